from .topics import exercise as exercise
from .triangles import de_boor_triangle as de_boor_triangle
from .triangles import elevation_triangles as elevation_triangles
from .triangles import insertion_triangle as insertion_triangle
from .triangles import product_tables as product_tables
