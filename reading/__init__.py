"""Reading a paper whole: its text cut into spans, and what each of them decides."""
