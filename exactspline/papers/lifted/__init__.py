"""Forms of the lowest degree, from the lifted curves P = (w, p) and X = (‖p‖², w p, w²): results of this project."""
