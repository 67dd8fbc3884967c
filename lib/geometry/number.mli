(** Numbers: the rules that a scene's numbers obey, and how they are shown. *)

type rule =
  | Finite  (** neither infinite nor NaN *)
  | Non_negative  (** finite and at least 0 *)
  | Positive  (** finite and greater than 0 *)

val broken : rule -> float -> string option
(** [broken rule x] is what [x] would have to be, such as
    ["must be greater than 0"], or [None] if [x] obeys [rule]. *)

val require : rule -> string -> float -> unit
(** [require rule name x] does nothing if [x] obeys [rule].

    Raises [Invalid_argument] with [name], [x] and the rule otherwise. *)

val pp : Format.formatter -> float -> unit
(** [pp] prints at most six significant digits and no needless zero: [2.5],
    [-1], [0.333333], [1e-07]. Negative zero is [0]. *)

val to_exact_string : float -> string
(** [to_exact_string x] is the shortest of the usual decimal forms of the
    finite [x] from which [float_of_string] gives [x] back. *)
