(* The extracted checker in single worlds.  Usage: runs [fifo|lifo|nearest]

   Each line {"sigma", "alpha", "place", "limit"}, a map rooted at dart 0 with the marker so many darts
   clockwise of it, is answered by the run of Algorithm 1 there (run_in) and what comes of it (examine):
   {"first", "steps", "estimate", "end", "finding"}.  A percept is [degree, bearing or null], a step
   [motion, percept]; the motion is given modulo the degree. *)
open Certified

let policy = match Sys.argv with
  | [| _ |] | [| _; "fifo" |] -> fifo | [| _; "lifo" |] -> lifo | [| _; "nearest" |] -> nearest
  | _ -> prerr_endline "usage: runs [fifo|lifo|nearest]"; exit 2

let percept (d, b) = Printf.sprintf "[%d,%s]" d (match b with None -> "null" | Some b -> string_of_int b)

let rec steps degree = function
  | [] -> []
  | (k, o) :: rest -> Printf.sprintf "[%d,%s]" (k mod degree) (percept o) :: steps (fst o) rest

let estimate = function
  | None -> "null"
  | Some e ->
      Printf.sprintf "{\"sigma\":%s,\"alpha\":%s,\"here\":%d}" (Json.show e.sigma_list)
        (Json.show e.alpha_list) e.root_number

let finding = function
  | NoAnswer -> "none"
  | Judged IsRight -> "right" | Judged WrongPose -> "pose" | Judged WrongMap -> "map"

let () =
  let r = algorithm1_resumption policy in
  try
    while true do
      let line = Json.parse (input_line stdin) in
      let ints key = Json.ints (Json.field key line) and int key = Json.int (Json.field key line) in
      let map = { sigma_list = ints "sigma"; alpha_list = ints "alpha"; root_number = 0 } in
      let most = int "limit" and w = (map, int "place") in
      if not (List.for_all (fun x -> x >= 0) (most :: snd w :: map.sigma_list @ map.alpha_list)
              && valid map && List.length (dart_order map) = List.length map.sigma_list)
      then (prerr_endline "the world is no connected map"; exit 2);
      let limit _ _ _ = most in
      let (taken, answer), last = run_in r limit directional_senses w in
      let first = directional_senses map (snd w) 0 in
      Printf.printf "{\"first\":%s,\"steps\":[%s],\"estimate\":%s,\"end\":%d,\"finding\":\"%s\"}\n"
        (percept first) (String.concat "," (steps (fst first) taken)) (estimate answer) last
        (finding (examine r limit directional_senses w))
    done
  with
  | End_of_file -> ()
  | Json.Malformed why -> prerr_endline why; exit 2
