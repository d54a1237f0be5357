"""One curve: its facts, joints, features, planarity and poles, and its values at a parameter."""
