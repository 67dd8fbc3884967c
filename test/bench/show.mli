(** Figures as text. NaN, which stands for what was not measured, is ["-"]. *)

val decimals : int -> float -> string
(** [decimals n x] is [x] with [n] decimals. *)

val ratio : float -> string
(** [ratio x] is [x] with two decimals. *)

val milliseconds : float -> string
(** [milliseconds s] is [s] seconds in milliseconds, without the unit. *)

val megabytes : float -> string
(** [megabytes b] is [b] bytes in units of 10^6 bytes, without the unit. *)

val count : int -> string
(** [count n] is [n], which is not negative, with commas: ["12,345"]. *)
