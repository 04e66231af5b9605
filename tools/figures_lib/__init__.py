"""Figures of the syllabus on sampling and BSDFs."""
