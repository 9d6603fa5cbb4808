"""Packages: nothing missing, nothing touched; else what is missing, or how to do it by hand."""

import unittest
from unittest import mock

from fake_kit import KitTestCase
from tumble import apt, packages
from tumble.console import Failure


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
        self.assertRegex(update, r"^-q .* update$")
        self.assertTrue(install.endswith(" install catch2 libstb-dev"), install)
        self.assertIn("--no-install-recommends", install)
        for call in (update, install):  # or a machine without a network is silent for long
            self.assertIn("Acquire::Retries=0", call)
            self.assertIn("Acquire::http::Timeout=10", call)

    def test_the_demo_leaves_to_verify_what_only_verify_takes(self) -> None:
        self.apt_that_works()
        only_verify = "lld libegl-dev libegl1 bubblewrap"
        self.kit.tumble("demo", settings={"MISSING": only_verify})
        self.assertEqual(self.kit.calls("apt-get"), [])
        self.kit.tumble("verify", settings={"MISSING": only_verify})
        for name in only_verify.split():
            self.assertIn(f" {name}", self.kit.calls("apt-get")[-1])

    def test_where_there_is_no_osmesa_the_demo_takes_egl(self) -> None:
        self.apt_that_works()
        self.kit.tumble("demo", settings={"MISSING": "libosmesa6-dev libegl-dev",
                                          "UNKNOWN": "libosmesa6-dev"})
        self.assertTrue(self.kit.calls("apt-get")[-1].endswith(" install libegl-dev"))

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
        self.assert_cause_and_remedy(done)
        self.assertIn("apt-get install --no-install-recommends cmake catch2\n", done.stderr)
        self.assertTrue((self.kit.root / "build" / "apt.log").exists())

    def test_when_apt_fails_its_own_reason_is_said(self) -> None:
        self.kit.add_tool("sudo", 'exec "$@"\n')
        self.kit.add_tool("apt-get", """
case "$*" in *" update") exit 0 ;; esac
echo "E: Failed to fetch http://x/y.deb   Temporary failure resolving 'x'"
echo "E: Unable to fetch some archives, maybe run apt-get update or try with --fix-missing?"
exit 100
""")
        done = self.kit.tumble("verify", settings={"MISSING": "catch2 cmake"})
        self.assert_cause_and_remedy(done)
        self.assertIn("2 packages are missing, and apt-get failed: Failed to fetch http://x/y.deb "
                      "Temporary failure resolving 'x' (more: build/apt.log)\n", done.stderr)

    def test_without_package_lists_the_reason_is_why_they_could_not_be_read(self) -> None:
        self.kit.add_tool("sudo", 'exec "$@"\n')
        self.kit.add_tool("apt-get", """
echo "$*" >> "$FAKE/calls/apt-get"
echo "E: Failed to fetch http://x/InRelease  Temporary failure resolving 'x'"
exit 100
""")
        done = self.kit.tumble("verify", settings={"MISSING": "catch2", "UNKNOWN": "catch2"})
        self.assert_cause_and_remedy(done)
        self.assertIn("Temporary failure resolving 'x'", done.stderr)
        self.assertEqual(len(self.kit.calls("apt-get")), 1)

    def test_an_optional_package_that_cannot_be_installed_stops_nothing(self) -> None:
        self.kit.add_tool("sudo", 'exec "$@"\n')
        self.assertEqual(self.kit.tumble("verify", settings={"MISSING": "lld"}).returncode, 0)

    def test_without_apt_the_packages_are_named(self) -> None:
        for tool in ("apt-get", "dpkg-query", "apt-cache"):
            (self.kit.tools / tool).unlink()
        done = self.kit.tumble("demo")
        self.assert_cause_and_remedy(done)
        self.assertIn("there is no apt-get", done.stderr)
        self.assertIn("libeigen3-dev", done.stderr)

    def test_without_root_and_sudo_the_command_that_helps_is_said(self) -> None:
        missing = [packages.Package("catch2", "the tests")]
        with mock.patch("os.geteuid", return_value=1000), \
                mock.patch("shutil.which", return_value=None), \
                self.assertRaises(Failure) as caught:
            packages.root_prefix(missing)
        cause, remedy = str(caught.exception).splitlines()
        self.assertIn("1 package is missing; installing needs root, and there is no sudo", cause)
        self.assertIn("as root, type: apt-get install --no-install-recommends catch2", remedy)

    def test_no_install_leaves_the_packages_alone(self) -> None:
        done = self.kit.tumble("verify", "--no-install", settings={"MISSING": "catch2"})
        self.assertEqual(done.returncode, 0)
        self.assertEqual(self.kit.calls("dpkg-query"), [])


class Counter(unittest.TestCase):
    def test_it_counts_what_apt_fetches_unpacks_and_sets_up(self) -> None:
        counter = apt.Counter(2)
        self.assertEqual(str(counter), "installing 2 packages")
        for line in ("0 upgraded, 3 newly installed, 0 to remove and 0 not upgraded.",
                     "Get:1 http://x bookworm/main a [5 kB]", "Get:2 http://x bookworm/main b",
                     "Selecting previously unselected package a.", "Unpacking a (1.0) ...",
                     "Setting up a (1.0) ..."):
            counter.read(line)
        self.assertEqual(str(counter), "installing 3 packages: 2 fetched, 1 unpacked, 1 set up")


if __name__ == "__main__":
    unittest.main()
