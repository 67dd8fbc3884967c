let pf = Printf.sprintf
let primary = "#1565c0"
let mirrored = "#8e24aa"
let lit = "#e09000"
let blocked = "#d32f2f"

let ink : Path.kind -> string = function
  | Primary -> primary
  | Mirrored | Unfollowed -> mirrored
  | Lit _ -> lit
  | Blocked _ -> blocked

let style (kind : Path.kind) =
  let look =
    match kind with
    | Primary | Mirrored -> {|stroke-width="2.2"|}
    | Unfollowed -> {|stroke-width="2.2" stroke-dasharray="2 3"|}
    | Lit _ | Blocked _ -> {|stroke-width="1.6" stroke-dasharray="6 4"|}
  in
  pf {|stroke="%s" %s|} (ink kind) look

let cross (x, y) =
  let style = pf {|stroke="%s" stroke-width="2.4"|} blocked in
  let arm dx dy = Svg.line ~style (x -. dx, y -. dy) (x +. dx, y +. dy) in
  [ arm 5. 5.; arm 5. (-5.) ]

(* [head ink tip (ux, uy)] is an arrow head of which [tip] is the front. *)
let head ink (x, y) (ux, uy) =
  let at along aside =
    (x +. (along *. ux) -. (aside *. uy), y +. (along *. uy) +. (aside *. ux))
  in
  let style = pf {|fill="%s"|} ink in
  Svg.polygon ~style [ at 0. 0.; at (-11.) 4.5; at (-11.) (-4.5) ]

let way (x, y) (x', y') =
  let dx = x' -. x and dy = y' -. y in
  let length = Float.hypot dx dy in
  (length, (dx /. length, dy /. length))
