# The front door: what is imported from `exactspline`, and what type checkers read of it. A name is imported when it is
# first used. The headings are those of the reference.
from .extras import teaching as teaching
from . import display as display
from . import interchange as interchange
from . import constructors as constructors
from . import language as language
from . import readings as readings
from . import tables as tables

# construction
from .splines.bspline import BSpline as BSpline
from .splines.nurbs import Nurbs as Nurbs
from .splines.nurbs import graph as graph
from .splines.surface import NurbsSurface as NurbsSurface
from .splines.tensor import TensorSpline as TensorSpline
from .splines.knots import KnotVector as KnotVector
from .splines.control_points import Direction as Direction
from .constructors import circle as circle
from .constructors import interpolate as interpolate
from .numbers.exact import rational as rational
from .numbers.exact import from_floats as from_floats
from .reals.real import Real as Real
from .reals.real import square_root as square_root

# files and examples
from .interchange.files import read as read
from .interchange.files import write as write
from .interchange.bridges import from_scipy as from_scipy
from .interchange.bridges import to_scipy as to_scipy
from .interchange.examples import example as example
from .interchange.examples import examples as examples

# evaluation
from .roots.values import evaluate as evaluate
from .geometry.analysis.floats import floats as floats
from .geometry.curves.values import curvature as curvature
from .geometry.curves.values import torsion as torsion
from .numbers.intervals import Side as Side

# zeros
from .roots.zero_set import ZeroSet as ZeroSet
from .roots.zero_set import zeros as zeros
from .roots.root import Root as Root
from .certificates import check_certificate as check_certificate

# analysis
from .geometry.analysis.curves import analyse as analyse
from .geometry.analysis.many_curves import features_of_curves as features_of_curves
from .geometry.analysis.ask import ask as ask
from .geometry.analysis.ask import nearest as nearest
from .batch.sweep import sweep as sweep
from .batch.corpus import Family as Family

# derived curves and surfaces
from .geometry.derived.derive import derive as derive
from .geometry.bisectors.any_pair import bisector as bisector

# points in common, distances, inside and outside
from .geometry.pairs.offsets import intersections as intersections
from .geometry.pairs.offsets import self_intersections as self_intersections
from .bivariate.zeros import common_zeros as common_zeros
from .bivariate.zeros import zero_curve as zero_curve
from .geometry.pairs.distance import distance as distance
from .geometry.pairs.winding import contains as contains
from .geometry.pairs.winding import winding_number as winding_number

# pictures
from .display.plot.anything import plot as plot
from .display.latex import latex as latex

# formulas and papers
from .papers import formula_of as formula_of
from .papers import paper as paper
from .verification.questions import degree as degree
from .verification.questions import prove as prove
from .verification.questions import reduction as reduction
from .verification.questions import verify as verify

# claims and their verdicts
from .verification.claims import claims as claims
from .verification.ledger import decide as decide
from .verification.vocabulary import Verdict as Verdict

# errors
from .errors import ExactSplineError as ExactSplineError

__version__: str
