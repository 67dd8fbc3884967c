open Raylab_window

let write path text =
  Out_channel.with_open_bin path (fun c -> output_string c text)

(* Waits for the file to settle. *)
let rec wait_for_change watch patience =
  if not (Watch.has_changed watch) then
    if patience = 0 then Alcotest.fail "the change is not seen"
    else (
      Unix.sleepf 0.02;
      wait_for_change watch (patience - 1))

let test_follow () =
  let folder = Filename.temp_dir "watch" "" in
  let main = Filename.concat folder "main"
  and other = Filename.concat folder "other" in
  write main "";
  write other "";
  let watch = Watch.start main in
  let check_seen path text =
    write path text;
    wait_for_change watch 1000
  in
  Watch.follow watch [ main; other ];
  check_seen main "a";
  check_seen other "a";
  Watch.follow watch [ main; other ];
  check_seen other "ab";
  Watch.follow watch [];
  check_seen main "ab";
  List.iter Sys.remove [ main; other ];
  Sys.rmdir folder

let suite = ("Watch", [ Alcotest.test_case "several files" `Quick test_follow ])
