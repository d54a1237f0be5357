"""What can be asked: the questions about curves, surfaces, maps and pairs, answered from all other rooms."""
