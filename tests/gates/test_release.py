"""What an index, a citation and a recipe say of this release is what the project says."""

import re
import tomllib
from pathlib import Path

import pytest

import exactspline

ROOT = Path(__file__).resolve().parents[2]
pytestmark = pytest.mark.skipif(not (ROOT / "README.md").exists(), reason="in the checkout only")
ADDRESS = "https://example.org/exactspline"
LINK = re.compile(r"\[[^]]*\]\(([^)]*)\)")


def page(repository):
    import importlib.util

    spec = importlib.util.spec_from_file_location("hatch_build", ROOT / "hatch_build.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module.page_for_an_index((ROOT / "README.md").read_text(encoding="utf-8"), repository)


def test_links_and_pictures_work_on_an_index_page():
    """Before, `docs/pictures/page.png` was looked for beside the page of the index."""
    targets = LINK.findall(page(ADDRESS))
    assert len(targets) > 20
    for target in targets:
        kind, _, path = target.removeprefix(f"{ADDRESS}/").partition("/main/")
        assert (ROOT / path.partition("#")[0]).is_file(), target
        assert kind == ("raw" if path.endswith(".png") else "blob")


def test_without_an_address_no_link_leads_nowhere():
    text = page("")
    assert not LINK.findall(text)
    assert "![" not in text
    assert "exact answers to compare with" in text


def test_a_release_has_one_number():
    cited = (ROOT / "CITATION.cff").read_text(encoding="utf-8")
    recipe = (ROOT / ".github" / "conda" / "recipe.yaml").read_text(encoding="utf-8")
    newest = re.search(r"^## (\S+) \((\d{4}-\d\d-\d\d)\)$", (ROOT / "CHANGELOG.md").read_text(encoding="utf-8"), re.M)
    assert newest[1] == exactspline.__version__
    assert f"\nversion: {exactspline.__version__}\ndate-released: {newest[2]}\n" in cited
    assert f'version: "{exactspline.__version__}"' in recipe


def test_the_recipe_needs_what_the_project_needs():
    project = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]
    recipe = (ROOT / ".github" / "conda" / "recipe.yaml").read_text(encoding="utf-8")
    run = re.search(r"run: \[(.*?)\]", recipe, re.DOTALL)[1]
    needed = {each.replace(" ", "").strip('"') for each in re.findall(r'"[^"]*"', run)}
    assert needed == {f"python{project['requires-python']}", *project["dependencies"]}
