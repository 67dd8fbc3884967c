open Raylab_parallel
open Raylab_tracer

type news =
  | Failed of string
  | Began of { scene : Prepared.t; picture : Picture.t; first_row : int }
  | Tile of Pass.t * Tile.t
  | Finished of float

type shared = {
  unread : news list Atomic.t;  (** the last first *)
  stopped : bool Atomic.t;
  over : bool Atomic.t;
}

type t = { shared : shared; domain : unit Domain.t }

let rec post shared one =
  let unread = Atomic.get shared.unread in
  if not (Atomic.compare_and_set shared.unread unread (one :: unread)) then
    post shared one

(* An edit may have made the picture smaller. *)
let rows_of scene rows =
  let all = Render.all_rows scene in
  match rows with
  | Some ({ Render.last; _ } as rows) when last <= all.last -> rows
  | _ -> all

let work shared ~domains ?rows ~clock load =
  let started = clock () in
  let stop () = Atomic.get shared.stopped in
  match load () with
  | Error message -> post shared (Failed message)
  | Ok _ when stop () -> ()
  | Ok scene ->
      let rows = rows_of scene rows in
      let picture = Render.blank ~rows scene in
      post shared (Began { scene; picture; first_row = rows.first });
      let (_ : Tally.t) =
        Render.refine ~domains ~rows ~stop picture scene
          ~on_tile:(fun pass tile -> post shared (Tile (pass, tile)))
      in
      if not (stop ()) then post shared (Finished (clock () -. started))

let start ~domains ?rows ~clock ~enter load =
  let shared =
    {
      unread = Atomic.make [];
      stopped = Atomic.make false;
      over = Atomic.make false;
    }
  in
  (* one is the caller's *)
  let domains = Int.min domains (Parallel.max_domains - 1) in
  let run () =
    enter ();
    Fun.protect
      ~finally:(fun () -> Atomic.set shared.over true)
      (fun () -> work shared ~domains ?rows ~clock load)
  in
  { shared; domain = Domain.spawn run }

let news { shared; _ } = List.rev (Atomic.exchange shared.unread [])
let stop { shared; _ } = Atomic.set shared.stopped true
let is_over { shared; _ } = Atomic.get shared.over
let join { domain; _ } = Domain.join domain
