"""Packages: nothing missing, nothing touched; else what is missing, or how to do it by hand."""

import os
import unittest

from fake_kit import KitTestCase


class Packages(KitTestCase):
    def setUp(self) -> None:
        super().setUp()
        self.kit.write("fake/junit.xml",
                       '<testsuite><testcase name="kit/a/b" status="run"/></testsuite>')
        self.kit.write("fake/console.txt", "100% tests passed, 0 tests failed out of 1\n"
                       "\nTotal Test time (real) =   0.01 sec\n")

    def apt_that_works(self) -> None:
        self.kit.add_tool("apt-get", 'echo "$*" >> "$FAKE/calls/apt-get"\necho "Setting up x"\n')
        self.kit.add_tool("sudo", 'exec "$@"\n')

    def test_nothing_missing_means_no_apt_and_no_root(self) -> None:
        for command in ("verify", "demo"):
            self.kit.tumble(command)
        self.assertEqual(self.kit.calls("apt-get"), [])
        self.assertEqual(self.kit.tumble("verify").returncode, 0)

    def test_only_what_is_missing_is_installed(self) -> None:
        self.apt_that_works()
        done = self.kit.tumble("verify", settings={"MISSING": "catch2 libstb-dev"})
        self.assertEqual(done.returncode, 0, done.stderr)
        update, install = self.kit.calls("apt-get")
        self.assertEqual(update, "-q update")
        self.assertTrue(install.endswith(" install catch2 libstb-dev"), install)
        self.assertIn("--no-install-recommends", install)

    def test_a_package_that_this_release_lacks_is_passed_over(self) -> None:
        self.apt_that_works()
        gone = {"MISSING": "libosmesa6-dev", "UNKNOWN": "libosmesa6-dev"}
        self.assertEqual(self.kit.tumble("verify", settings=gone).returncode, 0)
        self.assertEqual(self.kit.calls("apt-get"), [])
        gone["MISSING"] += " catch2"
        self.assertEqual(self.kit.tumble("verify", settings=gone).returncode, 0)
        self.assertTrue(self.kit.calls("apt-get")[-1].endswith(" install catch2"))

    def test_when_apt_fails_the_packages_are_named(self) -> None:
        self.kit.add_tool("sudo", 'exec "$@"\n')
        done = self.kit.tumble("verify", settings={"MISSING": "catch2 cmake"})
        self.assert_one_line(done, 1)
        self.assertIn("install by hand: cmake catch2", done.stderr)
        self.assertTrue((self.kit.root / "build" / "apt.log").exists())

    def test_an_optional_package_that_cannot_be_installed_stops_nothing(self) -> None:
        self.kit.add_tool("sudo", 'exec "$@"\n')
        self.assertEqual(self.kit.tumble("verify", settings={"MISSING": "lld"}).returncode, 0)

    def test_without_apt_the_packages_are_named(self) -> None:
        for tool in ("apt-get", "dpkg-query", "apt-cache"):
            (self.kit.tools / tool).unlink()
        done = self.kit.tumble("demo")
        self.assert_one_line(done, 1)
        self.assertIn("libeigen3-dev", done.stderr)

    def test_without_root_and_sudo_the_packages_are_named(self) -> None:
        if os.geteuid() == 0:
            self.skipTest("this is root")
        done = self.kit.tumble("verify", settings={"MISSING": "catch2"})
        self.assert_one_line(done, 1)
        self.assertEqual(self.kit.calls("apt-get"), [])

    def test_no_install_leaves_the_packages_alone(self) -> None:
        done = self.kit.tumble("verify", "--no-install", settings={"MISSING": "catch2"})
        self.assertEqual(done.returncode, 0)
        self.assertEqual(self.kit.calls("dpkg-query"), [])


if __name__ == "__main__":
    unittest.main()
