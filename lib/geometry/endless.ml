type t = {
  planes : Plane.t array; (* most are *)
  plane_numbers : int array;
  others : Shape.t array;
  other_numbers : int array;
}

let of_shapes shapes =
  let plane (number, shape) =
    match shape with Shape.Plane plane -> Some (number, plane) | _ -> None
  and other (_, shape) =
    match shape with
    | Shape.Plane _ -> false
    | _ -> Option.is_none (Shape.box shape)
  in
  let all = Array.to_seqi shapes in
  let planes = Array.of_seq (Seq.filter_map plane all)
  and others = Array.of_seq (Seq.filter other all) in
  {
    planes = Array.map snd planes;
    plane_numbers = Array.map fst planes;
    others = Array.map snd others;
    other_numbers = Array.map fst others;
  }

let[@inline] offer_plane { planes; plane_numbers; _ } k ray meeting =
  Plane.offer
    (Array.unsafe_get planes k)
    ray meeting
    ~number:(Array.unsafe_get plane_numbers k)

let offer_other { others; other_numbers; _ } k ray meeting =
  Shape.offer others.(k) ray meeting ~number:other_numbers.(k)

let offer endless ray meeting =
  for k = 0 to Array.length endless.planes - 1 do
    offer_plane endless k ray meeting
  done;
  for k = 0 to Array.length endless.others - 1 do
    offer_other endless k ray meeting
  done

let rec offer_others_until_one endless k ray meeting =
  if k < Array.length endless.others && Meeting.is_none meeting then (
    offer_other endless k ray meeting;
    offer_others_until_one endless (k + 1) ray meeting)

let rec offer_planes_until_one endless k ray meeting =
  if k < Array.length endless.planes && Meeting.is_none meeting then (
    offer_plane endless k ray meeting;
    offer_planes_until_one endless (k + 1) ray meeting)

let offer_until_one endless ray meeting =
  offer_planes_until_one endless 0 ray meeting;
  offer_others_until_one endless 0 ray meeting
