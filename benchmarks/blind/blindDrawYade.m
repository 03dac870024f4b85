% BLINDDRAWYADE  Draws sealed cases whose laboratory computes with YADE.
%
% CALL: TRUTHS = blindDrawYade (LAB, N)
%
%   LAB     struct of blindLab, for the benches Collapse and Heap
%   N       number of cases
%   TRUTHS  1 x N struct of blindDraw, and code ('yade')
%
% A third without an effect; then cohesion, tilt, meanSize, sizeSpread and drag
% in turn, of 0.4 to 1 of the strongest one on the list, in random order. From
% the random numbers that rand and randn are at.
%
% See also: blind, blindDraw, blindRun

function truths = blindDrawYade (lab, n)
  effects = {'cohesion', 'tilt', 'meanSize', 'sizeSpread', 'drag'};
  place = randperm (n);
  seeds = primes (60000);
  seeds = seeds(seeds > 20000);
  p = columns (lab.problem.limits);
  for i = 1:n
    at = place(i);
    truth = struct ('number', i, 'class', 'null', 'cause', {{}}, ...
                    'forms', {{}}, 'removed', '', 'phi', zeros (1, 0), ...
                    'level', 0, 'theta', rand (1, p), 'halfStep', false, ...
                    'seeds', seeds(randperm (numel (seeds), lab.trials)), ...
                    'noise', randn (lab.trials, columns (lab.sd)));
    truth.code = 'yade';
    if at > n / 3
      name = effects{1 + mod(at, numel (effects))};
      truth.class = 'single';
      truth.cause = {name};
      truth.forms = {{'yade', 'yadeCohesion'}{1 + strcmp(name, 'cohesion')}};
      truth.phi = 0.4 + 0.6 * rand ();
      signed = any (strcmp (name, {'tilt', 'meanSize'}));
      truth.phi = truth.phi * (1 - 2 * (signed && rand () < 0.5));
    end
    truths(i) = truth;
  end
end

%!test % a third without an effect, forms of another code
%! lab = struct ('problem', struct ('limits', [0, 0; 1, 1]), ...
%!               'trials', 3, 'sd', [1, 1]);
%! truths = blindDrawYade (lab, 12);
%! isNull = strcmp ({truths.class}, 'null');
%! assert (sum (isNull), 4);
%! phi = [truths.phi];
%! assert (numel (phi) == 8 && all (abs (phi) >= 0.4 & abs (phi) <= 1));
