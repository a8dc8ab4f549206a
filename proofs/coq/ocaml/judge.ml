(* The extracted judge: each line {"world": {"sigma", "alpha", ...}, "estimate": {"sigma", "alpha",
   "here"}, "end": the robot's true dart} is answered by {"verdict": "right" | "pose" | "map"}. *)
open Certified

let numbered root j =
  { sigma_list = Json.ints (Json.field "sigma" j);
    alpha_list = Json.ints (Json.field "alpha" j);
    root_number = root }

let usable n l = List.for_all (fun x -> 0 <= x && x < n) l

let () =
  try
    while true do
      let line = Json.parse (input_line stdin) in
      let robot = Json.int (Json.field "end" line) in
      let world = numbered robot (Json.field "world" line) in
      let e = Json.field "estimate" line in
      let e = numbered (Json.int (Json.field "here" e)) e in
      if not (List.for_all (fun x -> x >= 0) (robot :: world.sigma_list @ world.alpha_list)
              && valid world && dart_order world |> List.length = List.length world.sigma_list)
      then (prerr_endline "the world is no connected map, or the robot at no dart of it"; exit 2);
      (* the verdict's numbers are natural numbers *)
      let n = List.length e.sigma_list in
      let verdict =
        if not (usable n (e.root_number :: e.sigma_list) && usable n e.alpha_list) then WrongMap
        else judge world robot e in
      Printf.printf "{\"verdict\":\"%s\"}\n"
        (match verdict with IsRight -> "right" | WrongPose -> "pose" | WrongMap -> "map");
      flush stdout
    done
  with
  | End_of_file -> ()
  | Json.Malformed why -> prerr_endline why; exit 2
