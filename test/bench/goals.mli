(** The goals for raylab's speed, each a ratio within one run of the benchmark,
    so that it means the same on every machine. *)

type verdict = Met | Missed | Not_measured

type t = {
  what : string;
  aim : string;
  reached : string;  (** of several scenes the worst, with its name *)
  verdict : verdict;
}
(** The type for goals and what came of them. *)

val judge : domains:int -> first_pixel:float -> Trial.t list -> t list
(** [judge ~domains ~first_pixel trials] is all goals. [first_pixel] is in
    seconds, NaN if not measured. The goal for the speed-up, 3.6 with 4
    domains, is taken as 0.9 a domain. *)
