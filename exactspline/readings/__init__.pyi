from .degree import DegreeReading as DegreeReading
from .degree import parse_degree as parse_degree
from .jet import JetReading as JetReading
from .taylor import series_curve as series_curve
from .tree import trace as trace
