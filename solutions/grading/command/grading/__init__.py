"""Grading: submissions in, points and reports out. A hand-out ships without it."""
