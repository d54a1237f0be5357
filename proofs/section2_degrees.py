"""§2 of the paper (Chen, Riesenfeld and Cohen 2007): the degree calculus of Table 1.

An operand has a degree. A sum has the larger of the two degrees, a product has their sum, a derivative has one less,
and a quotient is differentiated by the quotient rule without cancelling. Each of the seventeen rows is computed from
the formula that runs and compared with the row of the paper.
"""

import pytest
from theorem import establish

from exactspline.verification.claims import all_claims


@pytest.mark.parametrize("row", [c.key for c in all_claims() if c.curve == "table" and c.kind == "degree"])
def test_row_of_table_1(row):
    """The degree of a row is as printed, for all degrees of the operands and on splines over different knots."""
    proved, verified = establish(row)
    assert (proved.verdict, verified.verdict) == ("PROVED", "VERIFIED")
    assert str(proved.computed) == proved.claimed
