(** Explanations for other programs, as JSON (RFC 8259).

    A document is an object [{ "version": 1, "pixels": [PIXEL, ...] }], where

    {v
    PIXEL = { "x": INT, "y": INT,             from the left, from the top
              "rgb": [INT, INT, INT],         the bytes that a picture shows
              "summary": STRING,              the sentence of Summary
              "ray": RAY }

    RAY   = { "origin": VECTOR, "direction": VECTOR,
              "reach": NUMBER or null,        where it ends; null: nowhere
              "left": INT,                    rays left in the chain
              "color": COLOR,
              "outcome": "hit", "missed" or "chain ended",
              "hit": HIT or null }            null unless it is "hit"

    HIT   = { "object": OBJECT,
              "t": NUMBER, "point": VECTOR, "normal": VECTOR,
              "offset": NUMBER,               along the normal, of rays to come
              "emission": COLOR, "albedo": COLOR, "mirror": NUMBER,
              "lights": [LIGHT, ...],         none if the albedo is 0
              "light": COLOR,                 the sum of their contributions
              "emitted": COLOR,               these three, added from the left,
              "diffused": COLOR,              are the colour of the ray
              "mirrored": COLOR,
              "reflection": RAY or null }     null if the mirror is 0

    OBJECT  = { "number": INT, "line": INT or null,
                "shape": { "kind": WORD, PART: NUMBER or VECTOR, ... },
                "surface": SURFACE }          as it is written

    SURFACE = { "kind": WORD, PART: NUMBER or COLOR, ... }
           or { "kind": "mixed",
                "parts": [{ "weight": NUMBER, "surface": SURFACE }, ...] }

    WORD    = what the scene language calls it
    PART    = what it takes there, in that order, by name:
              a "sphere" has "centre" and "radius", a "plane" has "point"
              and "normal"; "diffusive" and "luminous" have "color"

    LIGHT   = { "number": INT, "line": INT or null,
                "kind": "directional" or "spherical",
                "direction": VECTOR           if directional
                "position": VECTOR            if spherical
                "intensity": NUMBER, "color": COLOR,
                "verdict": "faces away", "blocked" or "lit",
                "cosine": NUMBER              if it faces away or is lit
                "shadow_ray":                 if blocked or lit
                  RAY, without left, color, outcome and hit;
                  or null                     if lit: the light is where it
                                              would start
                "by": OBJECT, "t": NUMBER, "point": VECTOR    if blocked
                "falloff": NUMBER, "contribution": COLOR }    if lit

    VECTOR  = [NUMBER, NUMBER, NUMBER]        x, y, z
    COLOR   = [NUMBER, NUMBER, NUMBER]        red, green, blue; 1 is bright
    v}

    Objects and lights are numbered by their place in the scene, from 1; [line]
    is where a scene file has them. A NUMBER has all the digits that a double
    needs to be read back as it was. It is null where the computation left the
    range of doubles, which does not happen at any size that a picture could
    show. New members may be added; a change that breaks readers gets a new
    version. *)

open Raylab_tracer

val of_ray : Explain.t -> Yojson.Safe.t
(** [of_ray e] is [e] as a RAY. *)

val document : ((int * int) * Explain.t) list -> Yojson.Safe.t
(** [document pixels] is the document about [pixels], each with the [(x, y)] of
    its place. *)

val to_string : Yojson.Safe.t -> string
(** [to_string json] is [json] laid out for a reader, or, if it nests very
    deep, on one line; with a line end. *)
