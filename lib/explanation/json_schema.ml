let text =
  {|PIXEL = { "x": INT, "y": INT,             from the left, from the top
          "rgb": [INT, INT, INT],         the bytes that a picture shows
          "summary": STRING,              the sentence of Summary
          "color": COLOR,                 the mean of the samples
          "film": { "samples": INT,       what the scene says, or options:
                    "exposure": NUMBER,   at most so many samples, the
                    "srgb": BOOL },       factor of colours, the encoding
          "cause": { "x": INT, "y": INT,  the pixel beside it because of
                     "color": COLOR }     which it has several samples, and
                   or null,               the colour of its centre
          "samples": [{ "color": COLOR,   of the ray, times the exposure and
                                          brought into 0 to 1
                        "ray": RAY }, ...] }

RAY   = { "origin": VECTOR, "direction": VECTOR,
          "reach": NUMBER or null,        where it ends; null: nowhere
          "seed": NUMBER,                 a number of its pixel and sample
          "share": NUMBER,                how much it counts in the colour
                                          of the first ray; less than 1 if
                                          others were sent on beside it
          "left": INT,                    rays left in the chain
          "color": COLOR,                 the terms, added from the left
          "outcome": "hit", "missed", "chain ended" or "too faint",
          "hit": HIT or null,             null unless it is "hit"
          "terms": [TERM, ...] }

TERM  = { "source": "background", "emitted", "diffused", "shine",
                    "mirrored" or "refracted",
          "color": COLOR,
          "light": COLOR                  if diffused: the sum of what the
                                          lights contribute
          "ambient": COLOR                of that, the ambient light, if there
                                          is some
          "sharpness": NUMBER,            if shine: of the highlight
          "shine": COLOR,                 if shine: the sum of what the lights
                                          give to it
          "index": NUMBER,                if refracted: the index of what is
                                          behind the surface
          "fresnel": NUMBER,              if refracted: of its glass so much
                                          is mirrored
          "cosine": NUMBER or null,       if refracted: of the angle between
                                          the ray and the normal; null if it
                                          is totally reflected
          "weight": COLOR,                if mirrored or refracted: what the
                                          ray's colour is multiplied by
          "ray": RAY or null }            if mirrored or refracted: the ray;
                                          null if the weight is 0

HIT   = { "object": OBJECT,
          "primitive": PRIMITIVE,         if that is a solid
          "here": SURFACE,                if the surface varies: what it
                                          is at the point
          "t": NUMBER, "point": VECTOR, "normal": VECTOR,
          "smoothed": VECTOR,             the normal by which light is
                                          reckoned, if that of a smooth
                                          mesh is another
          "outside": BOOL,                whether that is the normal on the
                                          outside of the object
          "part": INT,                    which part of the object or
                                          primitive is hit: of a box 0 to
                                          5, its left and right side,
                                          bottom, top, front and back; of a
                                          cylinder or cone 0, the wall, 1
                                          or 2, its ends; of a mesh which
                                          of its triangles, from 0
          "own_point": VECTOR,            the point in the object's own
                                          coordinates
          "offset": NUMBER,               along the normal, of rays to come
          "emission": COLOR, "albedo": COLOR, "mirror": COLOR,
          "highlights": [{ "sharpness": NUMBER, "color": COLOR }, ...],
                                          if there are any
          "refractions": [{ "index": NUMBER,
                            "refractive": COLOR,   let through
                            "fresnel": COLOR,      times Fresnel's share
                                                   mirrored
                            "glass": COLOR },      times the rest let
                           ...],                   through; if there are any
          "lights": [LIGHT, ...] }        none if the albedo is 0

OBJECT  = { "number": INT, PLACE,
            "shape": { "kind": WORD, PART: NUMBER or VECTOR, ... },
            "surface": SURFACE,           as it is written
            "modifiers": [{ "kind": WORD, PART: NUMBER or VECTOR, ... },
                          ...],           if they have made it another kind
                                          of shape
            "shadowless": true }          if no shadow ray meets it; of a
                                          solid there is, instead of shape,
                                          surface and modifiers,
            "solid": SOLID

SOLID   = { "kind": "union", "intersection" or "difference",
            "parts": [SOLID, ...] }
       or { "primitive": INT, "shape", "surface" and "modifiers" as above }

PRIMITIVE = { "number": INT, PLACE,       which one of the solid
              "taken_away": BOOL }        whether it cuts

SURFACE = { "kind": WORD, PART: NUMBER or COLOR, ... }
       or { "kind": "mixed",
            "parts": [{ "weight": NUMBER or COLOR, "surface": SURFACE },
                      ...] }
       or { "kind": "checker", "size": NUMBER,
            "even": SURFACE,              where the sum of the floors of
            "odd": SURFACE }              x, y and z over the size is so
       or { "kind": "varying",
            "text": STRING,               as the scene language writes it
            "where": [{ "name": NAME, "value": DATUM } or
                      { "name": NAME, "function": STRING }, ...] }
                                          what the names in it are, and
                                          functions as they are written

WORD    = what the scene language calls it
PART    = what it takes there, in that order, by name:
          a "sphere" has "centre" and "radius", a "plane" has "point"
          and "normal", a "box" has "low" and "high", a "cylinder" has
          "a", "b" and "radius", a "cone" has "a", "radius_a", "b" and
          "radius_b", a "torus" has "centre", "axis", "ring" and "tube",
          a "disc" has "centre", "normal" and "radius", a "triangle" has
          "a", "b" and "c", a "quad" has "corner", "edge" and "other";
          a "mesh" has "file" and, if it is smooth, "shading": "smooth";
          "diffusive" and "luminous" have "color", "glossy" has
          "sharpness" and "color", "refractive" and "glass" have "index"
          and "color";
          "scaled" has "factor", "stretched" has "factors", "rotated" has
          "axis" and "angle", "translated" has "way"

LIGHT   = { "number": INT, PLACE,
            "kind": WORD, PART: NUMBER or VECTOR, ...
                                          "directional" has "direction",
                                          "spherical" has "position", "spot"
                                          has "position", "target", "inner" and
                                          "outer", in degrees, "area" has
                                          "corner", "edge", "other" and
                                          "count"
            "intensity": NUMBER, "color": COLOR,
            "unfading": true,             if it is
            VERDICT }

VERDICT = { "verdict": "faces away", "outside", "blocked", "lit" or "mean",
            "angle": NUMBER               if it is outside of the cone of a
                                          spot: in degrees from its axis
            "points": [VERDICT, ...]      if it is an area light, and so the
                                          mean of what its points give
            "cosine": NUMBER              if it faces away or is lit
            "shadow_ray":                 if blocked or lit
              the origin, direction, reach and seed of a RAY;
              or null                     if lit: the light is where it
                                          would start
            "by": OBJECT, "t": NUMBER, "point": VECTOR    if blocked
            "primitive": PRIMITIVE        if that is by a solid
            "falloff": NUMBER             if lit
            "cone": { "angle": NUMBER,    if lit by a spot: the angle from its
                      "part": NUMBER }    axis, and which part of its light
                                          goes there
            "contribution": COLOR         if lit, or a mean
            "shines": [COLOR, ...]        likewise, if the surface has
                                          highlights: to each of them
            "past": OBJECT,               if lit: the first object in the
                                          way that is shadowless
            "through": [CROSSED, ...] }   if lit: the surfaces that the light
                                          goes through, the nearest to the
                                          hit first

CROSSED = { "object": OBJECT,
            "primitive": PRIMITIVE,       if that is a solid
            "t": NUMBER, "point": VECTOR,
            "part": COLOR }               what it lets through of the light

PLACE   = LINE,                           where it is written
          "made": [STEP, ...]             if calls or rounds made it, or it
                                          was placed by its name: what
                                          led there, the innermost first

LINE    = "line": INT or null,            null: of no file
          "file": STRING                  if not in the scene's own file

STEP    = { "call": NAME,                 in a call, written at LINE
            "arguments": [{ "name": NAME, "value": VALUE }, ...], LINE }
       or { "round": NAME, "value": VALUE, LINE }
                                          in a round of the loop at LINE
       or { "placed": NAME, LINE }        it was placed by this name

DATUM   = NUMBER, BOOL, STRING, VECTOR or SURFACE
       or [DATUM, ...]                    a list, in full
       or { "function": NAME }            a function that has this name
NAME    = STRING
VALUE   = NUMBER, BOOL, STRING or VECTOR
       or { "count": INT, "first": [VALUE, ...] }
                                          a list, and its first elements
       or { "what": STRING }              a function's name, or what else
                                          it is, such as "a surface"

VECTOR  = [NUMBER, NUMBER, NUMBER]        x, y, z
COLOR   = [NUMBER, NUMBER, NUMBER]        red, green, blue; 1 is bright|}
