; A model of the hypotheses of vertex-keeps-I1.smt2
; Says: The world is a triangle: v0 with darts a0 a1, v1 with b0 b1, v2 with c0 c1; edges a0b0,
;   a1c0, b1c1. S knows v0, v1 and a0b0; e = A1 leads to v2, which is new.
; Expected: sat

(set-logic ALL)
(declare-datatypes ((Dart 0)) (((a0) (a1) (b0) (b1) (c0) (c1))))
(declare-datatypes ((MapDart 0)) (((A0) (A1) (B0) (B1) (C0) (C1))))
(declare-datatypes ((Vertex 0)) (((v0) (v1) (v2))))
(declare-datatypes ((Degree 0)) (((two))))
(define-fun sigma ((x Dart)) Dart
  (ite (= x a0) a1 (ite (= x a1) a0 (ite (= x b0) b1 (ite (= x b1) b0 (ite (= x c0) c1 c0))))))
(define-fun alpha ((x Dart)) Dart
  (ite (= x a0) b0 (ite (= x a1) c0 (ite (= x b0) a0 (ite (= x b1) c1 (ite (= x c0) a1 b1))))))
(define-fun vertex ((x Dart)) Vertex
  (ite (= x a0) v0 (ite (= x a1) v0 (ite (= x b0) v1 (ite (= x b1) v1 v2)))))
(define-fun degree ((x Dart)) Degree two)
(define-fun marked ((x Dart)) Bool (or (= x a0) (= x a1)))
(define-fun seen0 ((x Dart)) Bool (or (= x a0) (= x a1) (= x b0) (= x b1)))
(define-fun walked0 ((x Dart)) Bool (or (= x a0) (= x b0)))
(define-fun known0 ((x MapDart)) Bool (or (= x A0) (= x A1) (= x B0) (= x B1)))
(define-fun explored0 ((x MapDart)) Bool (or (= x A0) (= x B0)))
(define-fun open0 ((x MapDart)) Bool (or (= x A1) (= x B1)))
(define-fun phi0 ((x MapDart)) Dart
  (ite (= x A0) a0 (ite (= x A1) a1 (ite (= x B0) b0 (ite (= x B1) b1 (ite (= x C0) c0 c1))))))
(define-fun name0 ((x Dart)) MapDart
  (ite (= x a0) A0 (ite (= x a1) A1 (ite (= x b0) B0 (ite (= x b1) B1 (ite (= x c0) C0 C1))))))
(define-fun next0 ((x MapDart)) MapDart
  (ite (= x A0) A1 (ite (= x A1) A0 (ite (= x B0) B1 (ite (= x B1) B0 (ite (= x C0) C1 C0))))))
(define-fun partner0 ((x MapDart)) MapDart
  (ite (= x A0) B0 (ite (= x A1) C0 (ite (= x B0) A0 (ite (= x B1) C1 (ite (= x C0) A1 B1))))))
(define-fun degree_map0 ((x MapDart)) Degree two)
(define-fun home0 ((x MapDart)) Bool (or (= x A0) (= x A1)))
(define-fun seen1 ((x Dart)) Bool (or (= x a0) (= x a1) (= x b0) (= x b1) (= x c0) (= x c1)))
(define-fun walked1 ((x Dart)) Bool (or (= x a0) (= x a1) (= x b0) (= x c0)))
(define-fun known1 ((x MapDart)) Bool
  (or (= x A0) (= x A1) (= x B0) (= x B1) (= x C0) (= x C1)))
(define-fun explored1 ((x MapDart)) Bool (or (= x A0) (= x A1) (= x B0) (= x C0)))
(define-fun phi1 ((x MapDart)) Dart
  (ite (= x A0) a0 (ite (= x A1) a1 (ite (= x B0) b0 (ite (= x B1) b1 (ite (= x C0) c0 c1))))))
(define-fun name1 ((x Dart)) MapDart
  (ite (= x a0) A0 (ite (= x a1) A1 (ite (= x b0) B0 (ite (= x b1) B1 (ite (= x c0) C0 C1))))))
(define-fun next1 ((x MapDart)) MapDart
  (ite (= x A0) A1 (ite (= x A1) A0 (ite (= x B0) B1 (ite (= x B1) B0 (ite (= x C0) C1 C0))))))
(define-fun partner1 ((x MapDart)) MapDart
  (ite (= x A0) B0 (ite (= x A1) C0 (ite (= x B0) A0 (ite (= x B1) C1 (ite (= x C0) A1 B1))))))
(define-fun degree_map1 ((x MapDart)) Degree two)
(define-fun home1 ((x MapDart)) Bool (or (= x A0) (= x A1)))
(define-fun new ((x MapDart)) Bool (or (= x C0) (= x C1)))
(define-fun fresh ((x Dart)) MapDart
  (ite (= x a0) A0 (ite (= x a1) A1 (ite (= x b0) B0 (ite (= x b1) B1 (ite (= x c0) C0 C1))))))
(define-fun e () MapDart A1)
(define-fun entry () MapDart C0)

(assert (forall ((d Dart)) (= (alpha (alpha d)) d)))
(assert (forall ((d Dart)) (= (vertex (sigma d)) (vertex d))))
(assert (forall ((c Dart) (d Dart)) (=> (= (vertex c) (vertex d)) (= (degree c) (degree d)))))
(assert (forall ((c Dart) (d Dart)) (=> (= (vertex c) (vertex d)) (= (marked c) (marked d)))))
(assert (forall ((d Dart) (c Dart)) (=> (and (seen0 d) (= (vertex c) (vertex d))) (seen0 c))))
(assert (forall ((d Dart)) (=> (walked0 d) (and (seen0 d) (walked0 (alpha d))))))
(assert (forall ((x MapDart)) (=> (known0 x) (and (seen0 (phi0 x)) (= (name0 (phi0 x)) x)))))
(assert (forall ((d Dart)) (=> (seen0 d) (and (known0 (name0 d)) (= (phi0 (name0 d)) d)))))
(assert (forall ((x MapDart))
  (=> (known0 x) (and (known0 (next0 x)) (= (phi0 (next0 x)) (sigma (phi0 x)))))))
(assert (forall ((x MapDart)) (=> (explored0 x) (and (known0 x) (walked0 (phi0 x))))))
(assert (forall ((x MapDart)) (=> (and (known0 x) (walked0 (phi0 x))) (explored0 x))))
(assert (forall ((x MapDart))
  (=> (explored0 x)
      (and (explored0 (partner0 x)) (= (partner0 (partner0 x)) x)
           (= (phi0 (partner0 x)) (alpha (phi0 x)))))))
(assert (forall ((x MapDart))
  (=> (known0 x)
      (and (= (degree_map0 x) (degree (phi0 x))) (= (home0 x) (marked (phi0 x)))))))
(assert (forall ((x MapDart)) (=> (open0 x) (known0 x))))
(assert (open0 e))
(assert (not (seen0 (alpha (phi0 e)))))
(assert (forall ((d Dart))
  (= (seen1 d) (or (seen0 d) (= (vertex d) (vertex (alpha (phi0 e))))))))
(assert (forall ((d Dart))
  (= (walked1 d) (or (walked0 d) (= d (phi0 e)) (= d (alpha (phi0 e)))))))
(assert (forall ((x MapDart))
  (= (new x) (exists ((d Dart)) (and (= (vertex d) (vertex (alpha (phi0 e)))) (= x (fresh d)))))))
(assert (forall ((d Dart)) (=> (= (vertex d) (vertex (alpha (phi0 e)))) (= (phi1 (fresh d)) d))))
(assert (= entry (fresh (alpha (phi0 e)))))
(assert (forall ((x MapDart)) (= (known1 x) (or (known0 x) (new x)))))
(assert (forall ((x MapDart)) (=> (known0 x) (= (phi1 x) (phi0 x)))))
(assert (forall ((d Dart)) (= (name1 d) (ite (seen0 d) (name0 d) (fresh d)))))
(assert (forall ((x MapDart)) (=> (known0 x) (= (next1 x) (next0 x)))))
(assert (forall ((d Dart))
  (=> (= (vertex d) (vertex (alpha (phi0 e)))) (= (next1 (fresh d)) (fresh (sigma d))))))
(assert (forall ((x MapDart)) (= (explored1 x) (or (explored0 x) (= x e) (= x entry)))))
(assert (forall ((x MapDart))
  (= (partner1 x) (ite (= x e) entry (ite (= x entry) e (partner0 x))))))
(assert (forall ((x MapDart))
  (= (degree_map1 x) (ite (new x) (degree (alpha (phi0 e))) (degree_map0 x)))))
(assert (forall ((x MapDart)) (= (home1 x) (ite (new x) (marked (alpha (phi0 e))) (home0 x)))))
(check-sat)
