"""What the compiler of a submission is given: all that its author was given to include."""

import re
import tempfile
import unittest
from pathlib import Path

from tumble.grading.compiling import Tools, prepare_kit
from tumble.labs import Lab, find_labs

from fake_kit import ROOT

_INCLUDE = re.compile(r'^#include "(common/[^"]+)"$', re.MULTILINE)


class Kit(unittest.TestCase):
    def headers(self, lab: Lab) -> Path:
        folder = Path(self.enterContext(tempfile.TemporaryDirectory(prefix="tumble-")))
        binary = folder / "binary"
        binary.write_bytes(b"")
        tools = Tools(binary, binary, (), binary, binary, folder, ())
        prepare_kit(ROOT, lab, b"", tools, folder / "kit")
        return folder / "kit"

    def test_whatever_a_contract_or_an_answer_includes_is_there(self) -> None:
        labs = find_labs(ROOT)
        self.assertTrue(labs)
        for lab in labs:
            kit = self.headers(lab)
            answers = (ROOT / "solutions" / lab.folder).glob("*.[ch]pp")
            waiting = [kit / f"{lab.name}.hpp", lab.stub, *answers]
            for path in waiting:
                for name in _INCLUDE.findall(path.read_text(encoding="utf-8")):
                    self.assertTrue((kit / name).is_file(), f"{path.name} includes {name}")
                    if kit / name not in waiting:
                        waiting.append(kit / name)


if __name__ == "__main__":
    unittest.main()
