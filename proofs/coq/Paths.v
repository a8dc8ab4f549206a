(* ---------------------------------------------------------------------------------------------
   Walks in S: from every known dart to v0, from v0 to every vertex, by simple paths.   Section VI

     joined S e v     some motions lead in S from the dart e to a dart of vertex v.
     all_joined S     every known dart is joined to v0, and v0 to every vertex.  It holds of the
                      first S and is kept by both augmentations: line 4 and line 9 always find
                      their path.
     simple_path      a path with no repeated vertex: fewer steps than S has vertices.
   --------------------------------------------------------------------------------------------- *)
From mathcomp Require Import all_ssreflect.
From Allworlds Require Import Model Maps Percepts PartialMaps.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Definition joined S a v := exists w f, follow S w a = Some f /\ f.1 = v.
Definition all_joined S := forall e, known S e -> joined S e 0 /\ joined S (0, 0) e.1.

Lemma follow_cat S w w' a f : follow S w a = Some f -> follow S (w ++ w') a = follow S w' f.
Proof.
by elim: w a => [|k w IH] a /=; [case=> -> | case: (partner S _) => [g|] //; exact: IH].
Qed.

Lemma joined_trans S w a f v : follow S w a = Some f -> joined S f v -> joined S a v.
Proof. by move=> R [w' [g [R' E]]]; exists (w ++ w'), g; rewrite (follow_cat _ R). Qed.

(* the turn from one dart of a vertex to another *)
Lemma turn_to S a e : known S a -> known S e -> a.1 = e.1 ->
  turn S (degree_in S a.1 - a.2 + e.2) a = e.
Proof.
case/andP=> _ l2 /andP[_ k2] E; rewrite /turn addnA subnKC ?(ltnW l2) //.
by rewrite modnDl E modn_small // -surjective_pairing.
Qed.

(* a path may begin at any dart of its first vertex *)
Lemma joined_turn S a a' v : joined S a v -> known S a' -> a'.1 = a.1 -> joined S a' v.
Proof.
case=> -[|k w] [f [R E]] /andP[_ l2] E1; first by exists [::], a'; rewrite E1 -E; case: R => ->.
exists (degree_in S a.1 - a'.2 + (a.2 + k) :: w), f; split=> //; rewrite -R /=.
suff -> : turn S (degree_in S a.1 - a'.2 + (a.2 + k)) a' = turn S k a by [].
by rewrite /turn -E1 addnA subnKC ?(ltnW l2) // modnDl.
Qed.

Section InWorld.
Variables (G : combinatorial_map) (v0 : G).
Local Notation embedded := (@embedded G v0).

Lemma joined_to S r d e : embedded S r -> all_joined S -> known S d -> known S e -> joined S d e.1.
Proof.
move=> I J kd ke; have [[w [f [R f0]]] _] := J d kd; have [_ A] := J e ke.
by have [kf _] := follow_phi I kd R; exact: (joined_trans R (joined_turn A kf f0)).
Qed.

(* ---- Augmentations keep the paths ---- *)
Lemma follow_mono S S' r w e f : embedded S r ->
  (forall x, known S x -> degree_in S' x.1 = degree_in S x.1) ->
  (forall x y, partner S x = Some y -> partner S' x = Some y) ->
  known S e -> follow S w e = Some f -> follow S' w e = Some f.
Proof.
move=> I dg lk; elim: w e => [|k w IH] e ke //=.
have -> : turn S' k e = turn S k e by rewrite /turn dg.
case L: (partner S _) => [g|] //; rewrite (lk _ _ L).
by have [_ kg _ _] := embedded_links I (partnerP L); exact: IH.
Qed.

Lemma joined_mono S S' r e v : embedded S r ->
  (forall x, known S x -> degree_in S' x.1 = degree_in S x.1) ->
  (forall x y, partner S x = Some y -> partner S' x = Some y) ->
  known S e -> joined S e v -> joined S' e v.
Proof. by move=> I dg lk ke [w [f [R E]]]; exists w, f; rewrite (follow_mono I dg lk ke R). Qed.

Lemma partner_mono S d l e h x y : is_open S e -> ~~ explored S h ->
  partner S x = Some y -> l = [:: (e, h), (h, e) & links S] -> partner (PartialMap d l) x = Some y.
Proof.
move=> /andP[_ oe] oh L ->; have lx : explored S x by apply/mapP; exists (x, y); rewrite ?partnerP.
rewrite /partner /=; case: eqP => [ex|_]; first by rewrite ex lx in oe.
by case: eqP => [hx|_ //]; rewrite hx lx in oh.
Qed.

Theorem all_joined_loop S r e h : embedded S r -> is_open S e -> is_open S h -> all_joined S ->
  all_joined (add_loop S e h).
Proof.
move=> I oe /andP[_ oh] Rc x kx; have [A B] := Rc x kx; have k0 := known_start I.
by split; apply: (joined_mono I) => // y z L; exact: (@partner_mono S _ _ e h).
Qed.

Lemma new_unexplored S r : embedded S r -> ~~ explored S (new_dart S).
Proof.
move=> I; apply/negP=> /exploredP[g m]; have [k1 _ _ _] := embedded_links I m.
by move: (new_unknown S); rewrite k1.
Qed.

Theorem all_joined_vertex S r e k : embedded S r -> is_open S e -> 0 < k -> all_joined S ->
  all_joined (add_vertex S e k).
Proof.
move=> I oe k0 Rc; have [ke _] := andP oe; have z0 := known_start I; set S' := add_vertex S e k.
have dg x : known S x -> degree_in S' x.1 = degree_in S x.1.
  by case/andP=> l1 _; rewrite /degree_in /= nth_rcons l1.
have lk x y : partner S x = Some y -> partner S' x = Some y.
  by move=> L; apply: (@partner_mono S _ _ e (new_dart S)) => //; exact: (new_unexplored I).
have kr x : known S x -> known S' x by exact: known_rcons.
have dn : degree_in S' (size (degrees S)) = k by rewrite /degree_in /= nth_rcons ltnn eqxx.
have le : partner S' e = Some (new_dart S) by rewrite /partner /= eqxx.
have ef : e != new_dart S by apply/eqP=> E; move: (new_unknown S); rewrite -E ke.
have lf : partner S' (new_dart S) = Some e by rewrite /partner /= (negbTE ef) eqxx.
have kf : known S' (new_dart S) by rewrite /known /= size_rcons ltnSn dn.
have Rf : follow S' [:: 0] (new_dart S) = Some e.
  by rewrite /= (_ : turn _ _ _ = new_dart S) ?lf // /turn /new_dart /= dn mod0n.
have Re : follow S' [:: 0] e = Some (new_dart S).
  rewrite /= (_ : turn _ _ _ = e) ?le // /turn addn0 dg // modn_small -?surjective_pairing //.
  by case/andP: ke.
move=> x; case/andP; rewrite size_rcons ltnS leq_eqVlt => /orP[/eqP x1|lx] l2.
  have kx : known S' x by rewrite /known /= size_rcons x1 ltnSn -x1.
  split.
    apply: (@joined_turn _ (new_dart S)) => //; apply: (joined_trans Rf).
    by apply: (joined_mono I) => //; case: (Rc e ke).
  have [_ [w [f [R E]]]] := Rc e ke; have [kff _] := follow_phi I z0 R.
  apply: (joined_trans (follow_mono I dg lk z0 R)).
  apply: (@joined_turn _ e) => //; last exact: kr.
  by exists [:: 0], (new_dart S); rewrite Re x1.
have kx : known S x.
  by move: l2; rewrite /known lx /degree_in /= nth_rcons lx.
by have [A B] := Rc x kx; split; apply: (joined_mono I).
Qed.

(* ---- Simple paths: by the vertices that a path visits, without the detours ---- *)
Definition neighbours S : rel nat := fun u v => has (fun q => (q.1.1 == u) && (q.2.1 == v)) (links S).

Lemma vertices_of_walk S r w a f : embedded S r -> known S a -> follow S w a = Some f ->
  exists2 p, path (neighbours S) a.1 p & last a.1 p = f.1.
Proof.
move=> I; elim: w a => [|k w IH] a ka /=; first by case=> ->; exists [::].
case L: (partner S _) => [g|] //; have m := partnerP L; have [_ kg _ _] := embedded_links I m.
case/(IH g kg) => p P E; exists (g.1 :: p) => //=; rewrite P andbT.
by apply/hasP; exists (turn S k a, g); rewrite //= !eqxx.
Qed.

Lemma walk_of_vertices S r p a : embedded S r -> known S a -> path (neighbours S) a.1 p ->
  exists w f, [/\ follow S w a = Some f, f.1 = last a.1 p & size w = size p].
Proof.
move=> I; elim: p a => [|v p IH] a ka /=; first by move=> _; exists [::], a.
case/andP=> /hasP[[[u i] [v' j]] m /= /andP[/eqP eu /eqP ev]] P; subst u v'.
have [ku kv E _] := embedded_links I m; have [w [f [R l sz]]] := IH (v, j) kv P.
exists (degree_in S a.1 - a.2 + i :: w), f; split=> //=; last by rewrite sz.
rewrite (turn_to ka ku) //=; have lk : explored S (a.1, i) by apply/mapP; exists ((a.1, i), (v, j)).
have [g Lg] := partner_total lk; rewrite Lg; have [_ kg Eg _] := embedded_links I (partnerP Lg).
by rewrite (phi_inj I kg kv) // -Eg -E.
Qed.

Theorem simple_path S r a v : embedded S r -> known S a -> joined S a v ->
  exists w f, [/\ follow S w a = Some f, f.1 = v & size w < size (degrees S)].
Proof.
move=> I ka [w [f [R <-]]]; have [p0 P0 <-] := vertices_of_walk I ka R.
case/shortenP: P0 => p P U _; have [w' [f' [R' E' sz]]] := walk_of_vertices I ka P.
exists w', f'; split=> //; rewrite sz -[_.+1]/(size (a.1 :: p)) -(size_iota 0 (size (degrees S))).
apply: uniq_leq_size => // x; rewrite inE mem_iota add0n leq0n /= => /orP[/eqP->|].
  by case/andP: ka.
move=> xp; have: all (fun y => y < size (degrees S)) p.
  elim: (p) a.1 P => //= y q IH z /andP[/hasP[[e g] m /= /andP[_ /eqP<-]] Q].
  by have [_ /andP[-> _] _ _] := embedded_links I m; exact: (IH _ Q).
by move/allP/(_ x xp).
Qed.

End InWorld.
