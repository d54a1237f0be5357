"""The tests of exactspline, in the shape of its rooms: a folder for each room of the package and three more.

``laws/`` holds what is true across rooms, ``journeys/`` what a person does from the door to the answer, ``gates/`` the
laws of the house. ``support/`` is what tests share: strategies, files, oracles that share no code with the package.
``campaigns/`` are commands that run longer than a test may, by a seed; the tests run a sample of each.
"""
