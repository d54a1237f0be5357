"""The colours of all pages: words in any of them can be read, by day and by night."""

import re
from importlib.resources import files

import pytest

STYLE = files("exactspline.display").joinpath("page.css").read_text(encoding="utf-8")
GROUNDS = {"paper", "card", "side", "line"}


def luminance(colour):
    """Relative luminance, as the guidelines for accessible content define it (WCAG 2, sRGB)."""
    parts = [int(colour[k : k + 2], 16) / 255 for k in (1, 3, 5)]
    red, green, blue = (x / 12.92 if x <= 0.04045 else ((x + 0.055) / 1.055) ** 2.4 for x in parts)
    return 0.2126 * red + 0.7152 * green + 0.0722 * blue


def contrast(one, other):
    dark, light = sorted(map(luminance, (one, other)))
    return (light + 0.05) / (dark + 0.05)


def test_the_contrast_of_black_and_white_is_21():
    assert contrast("#000000", "#ffffff") == pytest.approx(21)
    assert contrast("#777777", "#777777") == 1


@pytest.mark.parametrize("scheme", [0, 1])
def test_words_in_every_colour_stand_out(scheme):
    both = re.findall(r"--(\w+): light-dark\((#[0-9a-f]{6}), (#[0-9a-f]{6})\)", STYLE)
    colours = {name: pair[scheme] for name, *pair in both}
    words = colours.keys() - GROUNDS
    assert len(words) == 8
    poor = {
        (word, ground): contrast(colours[word], colours[ground])
        for word in words
        for ground in ("paper", "card", "side")
        if contrast(colours[word], colours[ground]) < 4.5
    }
    assert poor == {}
