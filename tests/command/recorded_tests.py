"""A kit whose test programs say what a test has them say."""

from fake_kit import LAB, KitTestCase
from student_records import NAMES, PASSED, RECORDS, record


class RecordedTests(KitTestCase):
    """Lab 1's programs play back what is recorded for them."""

    def setUp(self) -> None:
        super().setUp()
        self.kit.add_program(self.kit.root / f"build/dev/labs/{LAB}/spin_student_test",
                             'cat "$FAKE/records"\n')
        self.kit.add_program(self.kit.root / f"build/dev/labs/{LAB}/spin_student_sanitized_test",
                             'echo run >> "$FAKE/calls/sanitized"\n'
                             'if [ -f "$FAKE/found" ]; then cat "$FAKE/found"\n'
                             'else cat "$FAKE/records"; fi\n')
        self.record(RECORDS, NAMES)

    def record(self, records: bytes, names: str) -> None:
        self.kit.write(f"build/dev/labs/{LAB}/cases.txt", names)
        (self.kit.fake / "records").write_bytes(records)

    def record_steps(self, *outputs: str) -> None:
        """A case of step 1.i failed with output i, or passed where it is empty."""
        self.record(b"".join(record(line, output or PASSED, "exit 1" if output else "exit 0")
                             for line, output in enumerate(outputs)),
                    "".join(f"1.{step}|Case {step}\n" for step in range(1, len(outputs) + 1)))
