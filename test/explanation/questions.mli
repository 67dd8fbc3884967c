(** Questions about the gallery: why does this pixel look like that?

    The answers were written from the pictures, the texts of the scenes and a
    calculation by other means, before any explanation was looked at. Two
    things were put right afterwards: that calculation had started shadow and
    mirrored rays at a fixed distance from the surface, so some last digits
    changed, or fewer are asked for; and the green of [room]'s wall is dark
    green.

    Those about edges, blur and over-exposure were answered by the area that
    each thing has in the pixel, likewise by other means. Not all of those
    stood: where a thing has a sixth of the pixel, the first four samples may
    all miss it, and black beside black takes one sample; such pixels or
    answers were changed once that was seen, and those of [berries] were chosen
    from its picture.

    Those about glass were answered by a tracer of a page in another language,
    with the words for it made up beforehand; all stood.

    Those about [window] were answered from its text and picture, with points
    and angles worked out by another program. One word was put right, for how a
    mix is named. *)

type t = {
  scene : string;  (** the file in [scenes/], without [.scene] *)
  samples : int option;  (** those that the picture has, if not the scene's *)
  x : int;
  y : int;
  why : string;  (** what one wonders about when one looks at the picture *)
  summary : string list;  (** what the summary must say *)
  tree : string list;  (** what the tree must say *)
}

val all : t list
(** [all] is the questions, with their answers. *)
