; A true hypothesis always matches: induction step
; Says: If the robot is in the dart that h stands for, it can execute the motions of h to the end
;   and senses all that is expected. Step: true for the motions w, hence for k followed by w.
; Paper: IV ('if the hypothesis holds then the robot should be able to follow the planned path')
; Symbols:
;   Dart, MapDart  the darts of the world G; the darts of the map S
;   phi            the dart of G that a dart of S stands for (the paper's phi)
;   known          the dart is in S (its vertex is)
;   Degree         degrees of vertices, compared only
;   alpha          the other end of the same edge, in G; partner: in S, for explored darts
;   turn, back     sigma^k for a fixed k, and its inverse, in G; turn_map: sigma^k in S
;   degree, marked             percepts in G: degree, and whether the marker is there
;   degree_map, home           the same as expected from S
;   leads_w        w leads from the dart through S to v0.  leads_kw: for k followed by w
;   match_w        (match_w h x): w leads from h through S to v0, and the percepts of the robot
;                  walking w from x are those expected from h.  match_kw: for k followed by w
;   h              the hypothesis where the claim fails
; Expected: unsat

(set-logic UF)
(declare-sort Dart 0)
(declare-sort MapDart 0)
(declare-sort Degree 0)
(declare-fun alpha (Dart) Dart)
(declare-fun turn (Dart) Dart)
(declare-fun marked (Dart) Bool)
(declare-fun degree (Dart) Degree)
(declare-fun phi (MapDart) Dart)
(declare-fun known (MapDart) Bool)
(declare-fun explored (MapDart) Bool)
(declare-fun partner (MapDart) MapDart)
(declare-fun turn_map (MapDart) MapDart)
(declare-fun home (MapDart) Bool)
(declare-fun degree_map (MapDart) Degree)
(declare-fun leads_w (MapDart) Bool)
(declare-fun leads_kw (MapDart) Bool)
(declare-fun match_w (MapDart Dart) Bool)
(declare-fun match_kw (MapDart Dart) Bool)
(declare-const h MapDart)

; I-1: turning in S is turning in G (turns-carried-over)
(assert (forall ((e MapDart))
  (=> (known e) (and (known (turn_map e)) (= (phi (turn_map e)) (turn (phi e)))))))
; I-1: explored edges of S are edges of G
(assert (forall ((e MapDart))
  (=> (explored e) (and (known (partner e)) (= (phi (partner e)) (alpha (phi e)))))))
; I-1: S carries the degrees and the marker of G
(assert (forall ((e MapDart))
  (=> (known e) (and (= (degree_map e) (degree (phi e))) (= (home e) (marked (phi e)))))))
; k followed by w leads home
(assert (forall ((e MapDart))
  (= (leads_kw e) (and (explored (turn_map e)) (leads_w (partner (turn_map e)))))))
; a match along k followed by w
(assert (forall ((e MapDart) (d Dart))
  (= (match_kw e d)
     (and (= (degree_map e) (degree d)) (= (home e) (marked d))
          (explored (turn_map e)) (match_w (partner (turn_map e)) (alpha (turn d)))))))
; induction hypothesis
(assert (forall ((e MapDart)) (=> (and (known e) (leads_w e)) (match_w e (phi e)))))
; a hypothesis with its motions
(assert (known h))
(assert (leads_kw h))

; not: the test matches
(assert (not (match_kw h (phi h))))
(check-sat)
