"""A reader of Wavefront OBJ as far as formats.md and model.md speak of it.

`v`, `vn` and `f` with any of the four corner forms, positive or negative indices. `vt` is counted
by nobody: texture coordinates mean nothing here, and a negative `vt` index is never followed.
"""


def read_obj(text):
    """{"v": [...], "vn": [...], "faces": [[(vertex, normal or None), ...], ...]}, from 0."""
    mesh = {"v": [], "vn": [], "faces": []}
    for line in text.splitlines():
        words = line.split("#")[0].split()
        if not words:
            continue
        if words[0] in ("v", "vn"):
            mesh[words[0]].append([float(word) for word in words[1:4]])
        elif words[0] == "f":
            mesh["faces"].append([corner(word, mesh) for word in words[1:]])
    return mesh


def corner(word, mesh):
    parts = word.split("/")
    vertex = from_zero(parts[0], mesh["v"])
    has_normal = len(parts) == 3 and parts[2]
    return [vertex, from_zero(parts[2], mesh["vn"]) if has_normal else None]


def from_zero(word, so_far):
    """A negative index counts back from the last one read so far."""
    index = int(word)
    return index - 1 if index > 0 else len(so_far) + index


def triangles(mesh):
    """Faces fanned from their first corner (model.md, section 2, Mesh)."""
    for face in mesh["faces"]:
        for second, third in zip(face[1:], face[2:]):
            yield [face[0], second, third]
