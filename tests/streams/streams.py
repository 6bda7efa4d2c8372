"""The recorded call streams of this folder (NAME.trace, made by record.py), and the expectations for each."""
import dataclasses


@dataclasses.dataclass
class Stream:
    traced: float   # least share of its triangles that are traced
    batches: float  # most batches a frame; more mean unnecessary flushes
    # The first compared frame. glretrace's first frames go into a window that the real OpenGL takes for smaller than
    # it is: their images are empty or undefined.
    first: int = 1


STREAMS = {
    "glxgears": Stream(1, 1),
    "osgviewer_list": Stream(1, 1),
    "osgviewer_vbo": Stream(1, 1),
    "geomview": Stream(1, 1),
    "meshlab": Stream(0.85, 1),   # the rest: backdrop and text, depth test off
    "g3dviewer": Stream(1, 1),
    "openscad": Stream(0, 1),     # CSG passes with a stencil
    "ffmedit": Stream(0.49, 1),   # its second pass is a wireframe
    "freefem": Stream(0.98, 1),   # the rest: its legend, depth test off
    "sumo": Stream(0, 1),         # flat layers, in drawing order
    "pyopengl": Stream(1, 1),
    "drawxtl": Stream(1, 1),      # names every atom
    "v_sim": Stream(0.9, 1),      # the rest: its backdrop and legend, depth test off
    "pivy": Stream(1, 1),
    "3depict": Stream(1, 1),
    "superquadrics": Stream(1, 1),
    "glplanet": Stream(0.99, 3),  # day and night go to other channels, the atmosphere is blended: three batches
    "atlantis": Stream(0.98, 2),  # a layer without depth test splits the frame into two batches
    "gltext": Stream(1, 1),
    "pipes": Stream(1, 1),
}
