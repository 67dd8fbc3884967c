open Raylab_geometry

(* The channel whose full light is 60 n degrees before red. *)
let channel n ~h ~s ~v =
  let place = Range.modulo (n +. (h /. 60.)) 6. in
  let colourful = Range.clamp (Float.min place (4. -. place)) 0. 1. in
  let lost = v *. s *. colourful in
  v -. lost

let color ~h ~s ~v =
  let h = Range.modulo h 360. in
  Vec3.make (channel 5. ~h ~s ~v) (channel 3. ~h ~s ~v) (channel 1. ~h ~s ~v)
