(** The page of results. *)

type t = {
  machine : (string * string) list;  (** see {!Machine.describe} *)
  plan : Trial.plan;
  first_pixel : float list;  (** seconds, a run each *)
  povray_empty : Povray.t list;  (** runs of {!Povray.empty}, one thread *)
  trials : Trial.t list;
}
(** The type for everything that one run of the benchmark has measured. *)

val to_markdown : t -> string
(** [to_markdown results] is the page: machine, method, goals and tables. *)
