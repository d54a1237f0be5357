"""What one curve has: its facts, joints, features, planarity, poles, and its values at a parameter."""
