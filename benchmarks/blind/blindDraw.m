% BLINDDRAW  Draws sealed cases: what the laboratory's material really is.
%
% CALL: TRUTHS = blindDraw (LAB, N)
%
%   LAB     struct of blindLab
%   N       number of cases
%   TRUTHS  1 x N struct: number, class ('null', 'single', 'pair', 'unlisted',
%           'lookAlike'), cause (cellstr, listed effects that are there), forms
%           (cellstr, how each is made: 'library' or a name of blindForms; of
%           the unlisted their form), removed (effect taken off the list, ''),
%           phi (1 x c, strength in units of the listed effect, of causes on no
%           list the value of the form), level (signal to noise aimed at),
%           theta (1 x p, in [0, 1]), halfStep (logical, half the time step),
%           seeds (1 x trials, packings), noise (trials x T, standard normal)
%
% From the random numbers that rand and randn are at. Classes by lab.shares: no
% gap, one effect, two, a cause that is on no list; the rest a listed one that
% is taken off the list while others of its kind stay. At most a quarter of all
% cases use a form of the library. Parameters anywhere in the
% box, in every fifth case one within 5 % of a limit. Strengths by the signal to
% noise (1 to 12) that the library's form would have.
%
% See also: blind, blindForms, blindSpace

function truths = blindDraw (lab, n)
  classes = {};
  for name = fieldnames (lab.shares)'
    many = round (lab.shares.(name{1}) * n);
    classes = [classes, repmat(name, 1, many)];
  end
  classes(end + 1:n) = {'lookAlike'};
  classes = classes(randperm (n));
  counts = struct ('null', 0, 'single', 0, 'pair', 0, 'unlisted', 0, ...
                   'lookAlike', 0);
  for i = 1:n
    class = classes{i};
    counts.(class) = counts.(class) + 1;
    truths(i) = oneTruth (lab, i, class, counts.(class));
  end
end

% The library's own form: in each third null and each third single.
function truth = oneTruth (lab, number, class, count)
  T = columns (lab.sd);
  levels = [4, 8, 2, 6, 12, 3, 10, 5, 1];
  truth = struct ('number', number, 'class', class, 'cause', {{}}, ...
                  'forms', {{}}, 'removed', '', 'phi', zeros (1, 0), ...
                  'level', 0, 'theta', [], 'halfStep', false, ...
                  'seeds', packings (lab.trials), ...
                  'noise', randn (lab.trials, T));
  p = columns (lab.problem.limits);
  truth.theta = rand (1, p);
  if rand () < 0.2
    j = randi (p);
    truth.theta(j) = abs ((rand () < 0.5) - 0.05 * rand ());
  end
  space = blindSpace (lab, truth.theta);
  isOwn = mod (count, 3) == 0;
  truth.level = levels(1 + mod (count, numel (levels))) * ...
                ~any (strcmp (class, {'null', 'unlisted'}));
  switch class
    case 'null'
      truth.halfStep = ~isOwn;
    case 'single'
      truth = addCause (truth, lab, space, isOwn, '');
    case 'pair'
      truth.level = max (truth.level, 4);
      truth = addCause (truth, lab, space, false, '');
      truth = addCause (truth, lab, space, mod (count, 2) == 0, ...
                        truth.cause{1});
    case 'unlisted'
      forms = formsOf (lab);
      forms = forms(strcmp ({forms.effect}, ''));
      form = forms(1 + mod (count - 1, numel (forms)));
      truth.forms = {form.name};
      truth.phi = form.range(1) + rand () * diff (form.range);
    case 'lookAlike'
      truth.level = max (truth.level, 4);
      truth = addCause (truth, lab, space, false, '');
      truth.removed = truth.cause{1};
  end
end

function forms = formsOf (lab)
  forms = blindForms ();
  forms = forms(ismember ({forms.name}, lab.forms));
end

function seeds = packings (n)
  numbers = primes (60000);
  numbers = numbers(numbers > 20000);
  seeds = numbers(randperm (numel (numbers), n));
end

% One effect that can reach the level if there is one, in a form; not OTHER, and
% of its group only one, since LIGGGHTS has one law of attraction at a time.
function truth = addCause (truth, lab, space, isOwn, other)
  forms = formsOf (lab);
  forms = forms(~strcmp ({forms.effect}, ''));
  names = {lab.problem.effects.name};
  if isOwn
    choice = arrayfun (@(k) struct ('name', 'library', 'effect', names{k}), ...
                       1:numel (names));
  else
    choice = rmfield (forms, {'variable', 'factor', 'range', 'patch'});
  end
  bonds = {'cohesion', 'wallAdhesion', 'liquidBridge'};
  taken = {other};
  if any (strcmp (other, bonds))
    taken = bonds;
  end
  choice = choice(ismember ({choice.effect}, setdiff (names, taken)));
  choice = choice(randperm (numel (choice)));
  best = struct ('d', -1);
  for one = choice
    k = find (strcmp (names, one.effect));
    phi = strengthFor (lab, space, k, truth.level);
    d = space.visible (space.shape (k, phi));
    if d > best.d + 1e-9
      best = struct ('d', d, 'choice', one, 'phi', phi);
    end
    if d > 0.9 * truth.level
      break
    end
  end
  truth.cause{end + 1} = best.choice.effect;
  truth.forms{end + 1} = best.choice.name;
  truth.phi(end + 1) = best.phi;
end

% The weakest strength, on a grid, that reaches the level; full where none does.
function phi = strengthFor (lab, space, k, level)
  range = lab.problem.effects(k).range;
  side = 1;
  if range(1) < 0 && rand () < 0.5
    side = -1;
  end
  grid = side * (0.05:0.05:1);
  d = arrayfun (@(s) space.visible (space.shape (k, s)), grid);
  phi = side;
  if any (d >= level)
    phi = grid(find (d >= level, 1));
  end
end

%!test % classes, forms and strengths of a draw on a laboratory of formulas
%! [given, data] = smallGapLab ();
%! given.value = mean (data.Z);
%! names = {'cohesion', 'drag', 'sizeSpread', 'shape', 'gain'};
%! for k = 1:5
%!   given.effects(k).name = names{k};
%! end
%! options = gapOptions ([]);
%! problem = newProblem (given);
%! emulator = fitEmulator (problem, data, options);
%! lab = struct ('trials', 2, 'sd', given.sd, 'problem', problem, ...
%!               'emulator', emulator, 'hypotheses', ...
%!               makeHypotheses (problem, emulator, options), ...
%!               'shares', struct ('null', 0.3, 'single', 0.4, ...
%!                                 'pair', 0.1, 'unlisted', 0.1), ...
%!               'forms', {{'sjkr2', 'fiveSizes', 'squareDrag', ...
%!                          'fourSpheres', 'cdt', 'hooke'}});
%! rand ('twister', 3);
%! randn ('twister', 3);
%! truths = blindDraw (lab, 20);
%! number = @(class) sum (strcmp ({truths.class}, class));
%! assert ([number('null'), number('single'), number('pair')], [6, 8, 2]);
%! isOwn = cellfun (@(f) any (strcmp (f, 'library')), {truths.forms});
%! assert (sum (isOwn) <= 4);
%! for t = truths(strcmp ({truths.class}, 'single'))
%!   space = blindSpace (lab, t.theta);
%!   k = find (strcmp (names, t.cause{1}));
%!   d = space.visible (space.shape (k, t.phi));
%!   assert (d >= t.level || abs (t.phi) == 1);
%! end
%! for t = truths(strcmp ({truths.class}, 'lookAlike'))
%!   assert ({t.removed}, t.cause);
%! end
