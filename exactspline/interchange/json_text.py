"""JSON with every number kept as the text it shows."""

from __future__ import annotations

import json
from typing import NoReturn

from exactspline.errors import CurveFileError, NumberError
from exactspline.splines.json_files import once_each

#: What a JSON text holds, numbers as text.
Json = dict[str, "Json"] | list["Json"] | str | bool | None


def parsed(text: str) -> Json:
    """The data, numbers as text.

    >>> parsed('{"a": [1, 0.1, "x"]}')
    {'a': ['1', '0.1', 'x']}

    Raises `CurveFileError` for what is not JSON or has a field twice, `NumberError` for NaN and the infinities.
    """
    try:
        data: Json = json.loads(
            text, parse_int=str, parse_float=str, parse_constant=_refuse, object_pairs_hook=once_each
        )
        return data
    except RecursionError:
        raise CurveFileError("brackets are nested too deep", remedy="a curve needs three levels") from None
    except json.JSONDecodeError as error:
        raise CurveFileError(
            f"is not JSON ({error.msg})", where=f"line {error.lineno}", remedy="correct the text there"
        ) from None


def _refuse(word: str) -> NoReturn:
    raise NumberError(f"{word} is not a number", remedy="write finite numbers")
