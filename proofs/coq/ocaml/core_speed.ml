(* Episodes a second of the extracted explorer, judged by the extracted judge, without a pipe: every
   rooted map with up to M edges and every bearing.  The maps are enumerated here, by filtering.
   Usage: core_speed [M] [fifo|lifo|nearest]   (default 4 fifo) *)
open Certified

let edges = if Array.length Sys.argv > 1 then int_of_string Sys.argv.(1) else 4
let policy = match Array.to_list Sys.argv with
  | _ :: _ :: "lifo" :: _ -> lifo | _ :: _ :: "nearest" :: _ -> nearest | _ -> fifo

(* A rooted map numbered breadth first, sigma before alpha, root 0: grown one value at a time. *)
let rooted_maps m visit =
  let n = 2 * m in
  let sigma = Array.make n (-1) and alpha = Array.make n (-1) and taken = Array.make n false in
  let rec at d known =
    if d = n then visit sigma alpha
    else if d < known then begin
      for s = 0 to min known (n - 1) do
        if not taken.(s) then begin
          sigma.(d) <- s; taken.(s) <- true;
          let known = max known (s + 1) in
          if alpha.(d) >= 0 then at (d + 1) known
          else
            for a = d + 1 to min known (n - 1) do
              if alpha.(a) < 0 then begin
                alpha.(d) <- a; alpha.(a) <- d;
                at (d + 1) (max known (a + 1));
                alpha.(d) <- -1; alpha.(a) <- -1
              end
            done;
          sigma.(d) <- -1; taken.(s) <- false
        end
      done
    end in
  at 0 1

let () =
  Printf.printf "edges   runs  right  traversals  rooted only\n";
  let episodes = ref 0 and seconds = ref 0. in
  for m = 1 to edges do
    let worlds = ref [] in
    rooted_maps m (fun s a -> worlds := (Array.copy s, Array.copy a) :: !worlds);
    let runs = ref 0 and right = ref 0 and total = ref 0 and rooted = ref 0 in
    let began = Sys.time () in
    List.iter (fun (s, a) ->
      let n = Array.length s in
      let orbit d = let rec go x l = if x = d then List.rev l else go s.(x) (x :: l) in go s.(d) [d] in
      let orbits = Array.init n (fun d -> Array.of_list (orbit d)) in
      let moves k d = let o = orbits.(d) in a.(o.(k mod Array.length o)) in
      let world = { sigma_list = Array.to_list s; alpha_list = Array.to_list a; root_number = 0 } in
      Array.iter (fun pointed ->
        let percepts = Array.init n (fun d ->
          let o = orbits.(d) in
          let rec find i = if i = Array.length o then None else if o.(i) = pointed then Some i else find (i + 1) in
          (Array.length o, find 0)) in
        let senses d = percepts.(d) in
        let (transcript, answer), z =
          algorithm1_machine policy moves senses max_int (algorithm1_starts (senses 0)) 0 in
        let cost = List.length transcript in
        incr runs;
        total := !total + cost;
        if pointed = 0 then rooted := !rooted + cost;
        match answer with
        | Some e -> (match judge world z e with IsRight -> incr right | _ -> ())
        | None -> ()) orbits.(0)) !worlds;
    let took = Sys.time () -. began in
    episodes := !episodes + !runs; seconds := !seconds +. took;
    Printf.printf "%5d %6d %6d %11d %12d\n%!" m !runs !right !total !rooted;
    if !right < !runs then exit 1
  done;
  Printf.printf "%.0f judged episodes a second\n" (float !episodes /. !seconds)
