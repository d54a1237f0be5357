"""Work on many curves: `exactspline.batch.sweep` over corpora, in processes of this machine or on a cluster, with
results that survive a kill.
"""
