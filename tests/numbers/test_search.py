"""The order in which parts are looked at, and what stays open."""

import pytest

from exactspline.numbers.search import Search


@pytest.mark.parametrize(("depth_first", "order"), [(False, "a b aa ab ba bb"), (True, "a aa ab b ba bb")])
def test_parts_follow_at_the_end_or_at_once(depth_first: bool, order: str):
    search, seen = Search(["a", "b"], depth_first=depth_first), []
    for part in search:
        seen.append((part, search.depth))
        if part in ("a", "b"):
            search.split([part + "a", part + "b"])
    assert [part for part, _ in seen] == order.split()
    assert all(depth == len(part) - 1 for part, depth in seen)


def test_what_is_not_split_is_open_and_nothing_else():
    search = Search([16, 3], depth_first=True)
    for part in search:
        if part > 3:
            search.split([part // 2] * 2 if search.depth < 2 else None)
    assert search.open == [4] * 4
    assert search.seen == 1 + 2 + 4 + 1
