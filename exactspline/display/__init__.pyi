from .latex import latex as latex
from .notebook import html as html
from .notebook import load_ipython_extension as load_ipython_extension
from .notebook import short as short
