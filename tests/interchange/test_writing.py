"""Files are there whole or not at all, and what is not a file is left alone."""

import os
import stat

import pytest

from exactspline.atomic_write import write_atomically, write_text
from exactspline.errors import CurveFileError


def test_a_pipe_is_refused_and_left_alone(tmp_path):
    pipe = tmp_path / "pipe"
    os.mkfifo(pipe)
    with pytest.raises(CurveFileError, match="not a regular file"):
        write_atomically(pipe, lambda stream: stream.write(b"x"))
    assert stat.S_ISFIFO(pipe.stat().st_mode)
    assert list(tmp_path.iterdir()) == [pipe]


def test_a_folder_is_refused(tmp_path):
    with pytest.raises(CurveFileError, match="not a regular file"):
        write_atomically(tmp_path, lambda stream: stream.write(b"x"))


def test_a_link_stays_a_link(tmp_path):
    target, link = tmp_path / "target", tmp_path / "link"
    target.write_bytes(b"old")
    link.symlink_to(target)
    write_atomically(link, lambda stream: stream.write(b"new"))
    assert link.is_symlink()
    assert target.read_bytes() == b"new"


def test_links_in_a_circle_are_refused(tmp_path):
    (tmp_path / "a").symlink_to(tmp_path / "b")
    (tmp_path / "b").symlink_to(tmp_path / "a")
    with pytest.raises(CurveFileError):
        write_atomically(tmp_path / "a", lambda stream: stream.write(b"x"))


def test_a_failure_leaves_the_old_file_and_nothing_else(tmp_path):
    place = tmp_path / "curve.json"
    place.write_bytes(b"old")

    def write(stream):
        stream.write(b"half")
        raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        write_atomically(place, write)
    assert place.read_bytes() == b"old"
    assert list(tmp_path.iterdir()) == [place]


@pytest.mark.skipif(os.name == "nt", reason="modes of POSIX")
def test_a_file_keeps_its_mode_and_a_new_one_has_that_of_the_system(tmp_path):
    """Passed before: a private file was 0644 after it was written over, whatever the mask of new files."""
    private, new, plain = tmp_path / "private", tmp_path / "new", tmp_path / "plain"
    private.write_text("before")
    private.chmod(0o600)
    before = os.umask(0o027)
    try:
        write_text(private, "behind")
        write_text(new, "new")
        plain.write_text("made by Python alone")
    finally:
        os.umask(before)
    assert private.read_text() == "behind"
    assert [stat.S_IMODE(file.stat().st_mode) for file in (private, new)] == [0o600, 0o640]
    assert new.stat().st_mode == plain.stat().st_mode
    assert sorted(tmp_path.iterdir()) == [new, plain, private]
