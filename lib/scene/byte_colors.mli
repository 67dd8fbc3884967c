(** Colours that look like bytes, from 0 to 255. *)

val warnings :
  background:Background.t ->
  ambient:Color.t ->
  Light.t list ->
  Object.t list ->
  Warning.t list
(** [warnings ~background ~ambient lights objects] tells of each colour whose
    channels are whole numbers up to 255, one of them 100 or more: other
    programs write colours so, and here 1 is as bright as a picture shows. *)
