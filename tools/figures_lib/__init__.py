"""Figures of the syllabus on sampling."""
