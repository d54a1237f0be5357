"""Printers: LaTeX and text. They walk trees and know nothing else."""
