(** Shadows: what of a light comes along a shadow ray. A part of {!Lighting}.

    A shadow ray goes straight on through what refracts, weakened by each such
    surface that it meets, the nearest first. It ends after a thousand of them.
*)

open Raylab_scene

val is_seen : Registers.t -> int -> bool
(** [is_seen t light] is whether anything of the light of this number comes
    along the shadow ray in its register: then the register [tint] is the part
    that does. It leaves the shadow ray as it is, but for its reach. *)

val reset : Registers.t -> unit
(** [reset t] makes the tint white, as where there is no shadow ray. *)

val is_tinted : Registers.t -> bool
(** [is_tinted t] is whether there is anything in the scene that light goes
    through; if not, the tint is white. *)

val add : Registers.t -> Raw_color.t -> Raw_color.t -> unit
(** [add t gives sum] adds what a light gives, times the tint, to [sum]. *)

(** {1 For observers} *)

val blocker : Registers.t -> reach:float -> Event.obstacle
(** [blocker t ~reach] is what the shadow ray, of this reach, meets first that
    lets nothing through, after [is_seen] has said that there is such. *)

val crossings : Registers.t -> Event.crossing list
(** [crossings t] is what the light has gone through, the nearest first. *)
