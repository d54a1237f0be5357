"""§2. The degree calculus of Table 1.

An operand has a degree; a sum has the larger of the two, a product their sum, a derivative one less, and a quotient is
differentiated by the quotient rule without cancelling anything. Seventeen rows, each read off the formula that runs and
compared with the row of the paper.
"""

import pytest
from theorem import establish

from exactspline.verification.claims import all_claims


@pytest.mark.parametrize("row", [c.key for c in all_claims() if c.curve == "table" and c.kind == "degree"])
def test_row_of_table_1(row):
    """The degree is as printed, for all degrees and on splines over different knots."""
    proved, verified = establish(row)
    assert (proved.verdict, verified.verdict) == ("PROVED", "VERIFIED")
    assert str(proved.computed) == proved.claimed
