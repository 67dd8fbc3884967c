(** Regular files that appear whole or not at all, where the system allows it.

    What fails does so with [Unix.Unix_error], with what the writer fails with,
    or with {!Failed}. *)

type outcome =
  | Whole  (** it came into its place in one step *)
  | In_place of string
      (** it had to be copied over what was there, for this reason: it is a
          mount point, or its folder does not let it be replaced *)

exception Failed of string
(** A reason in words, for the user. *)

val write : string -> Unix.stats option -> (out_channel -> unit) -> outcome
(** [write path old write] lets [write] fill a temporary file beside [path],
    flushes it to the disk and renames it to [path]. [old] is what is there
    now; its mode is kept, and its owner as far as the system lets one. If no
    file can be made there the temporary one is in the folder for such files,
    and copied. *)

val check : string -> Unix.stats option -> bytes:int -> unit
(** [check path old ~bytes] fails as {!write} would fail for a reason that can
    be known before, such as that there is no room for [bytes]. It leaves
    everything as it is. *)
