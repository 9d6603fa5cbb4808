"""The command ./tumble: drives CMake, CTest and the labs' programs, and explains what they say."""

from pathlib import Path

# The commands of a course stand with the solutions, so that a hand-out has neither.
__path__.append(str(Path(__file__).resolve().parents[3] / "solutions" / "grading" / "command"))
