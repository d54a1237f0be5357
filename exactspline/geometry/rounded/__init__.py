"""What is true of all curves and surfaces near one whose numbers were rounded, and how far it stays true."""
