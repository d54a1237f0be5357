"""Papers: ``paper new``, ``paper figures``."""
