(** Sheets: white pages of drawings, some of them in panels. *)

(** The type for the parts of a sheet. *)
type part =
  | Free of Drawing.t
  | Panel of {
      name : string;  (** one word, which no other panel of the sheet has *)
      box : Rectangle.t;
      paper : Drawing.look;  (** of the box *)
      drawing : Drawing.t;  (** only what is in the box shows *)
    }

type t = {
  width : float;
  height : float;
  title : string;  (** what a reader of the screen says *)
  parts : part list;
}
(** The type for sheets. *)
