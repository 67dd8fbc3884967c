(** The prompt itself. *)

val prepare : unit -> unit
(** [prepare ()] makes the toplevel ready to evaluate: paths, what is open, the
    printers. *)

val script : string -> int
(** [script path] runs the OCaml script at [path] and is its exit status: 0, or
    2 after an error or an exception, which it reports on standard error. *)

val terminal : greeting:(unit -> unit) -> unit
(** [terminal ~greeting] runs utop until its user leaves, and ends the program.
    [greeting] is run before the first prompt. *)

val plain_terminal : greeting:(unit -> unit) -> unit
(** [plain_terminal ~greeting] is likewise a prompt, for a terminal that obeys
    no escape codes: without editing and colours. *)

val standard_input : unit -> unit
(** [standard_input ()] evaluates what comes from standard input and prints the
    values as a prompt does, without a prompt; it ends the program. *)
