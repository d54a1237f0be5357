"""What there is: ``list curves``, ``list formulas``, ``list words``, …."""
