% HASHMODELS  Hashes of what decides a run besides its variables.
%
% CALL: H = hashModels (CASE)
%
%   CASE  see newCase
%   H     1 x M struct array: input (files of the model that the simulation
%         reads, number of CPUs, LIGGGHTS build), funs (files of OctaveFuns,
%         which only evaluate), defaults (values declared in data.head; of
%         effect variables that it does not declare the neutral ones)
%
% A change in OctaveFuns asks for a new evaluation of finished runs, not for
% new simulations. README, sample and pictures decide nothing.
%
% See also: runKey, hashEvaluation, collectRuns

function h = hashModels (Case)
  aside = {'OctaveFuns', 'sample', 'README.md', 'README', 'picture.png', ...
           'picture.svg', 'log.liggghts', '.git'};
  build = hashBuild ();
  neutral = neutralEffects (Case);
  h = struct ('input', cell (1, numel (Case.models)), 'funs', '', ...
              'defaults', []);
  for k = 1:numel (Case.models)
    folder = Case.models(k).folder;
    text = sprintf ('%s|%d|%s', hashFolder (folder, aside), ...
                    Case.models(k).cpu, build);
    h(k).input = hash ('sha256', text);
    h(k).funs = hashEvaluation (Case.models(k));
    h(k).defaults = headDefaults (fullfile (folder, 'data.head'));
    % a model without the effect has it off: its runs stay the same ones
    for v = find (~isfield (h(k).defaults, Case.effectVars))
      h(k).defaults.(Case.effectVars{v}) = neutral(v);
    end
  end
end

function key = hashBuild ()
  [~, text] = system ('b=$(command -v liggghts) && sha256sum < "$b"');
  key = strtok (text);
end

%!test
%! Case = newCase (standInCase (tempname ()));
%! h = hashModels (Case);
%! assert (numel (h), 2);
%! assert (numel (h(1).input), 64);
%! assert (isequal (h, hashModels (Case)));
%! Case.models(1).cpu = 2;
%! g = hashModels (Case);
%! assert (! isequal (g(1).input, h(1).input));
%! assert (isequal (g(2).input, h(2).input));
%!test
%! % an effect that only one model has: runs of the other stay the same runs
%! Case = newCase (standInCase (tempname ()));
%! old = newJobs (Case, [1, 2], [], 1, 'plan');
%! writeAtomic (fullfile (Case.models(1).folder, 'data.head'), ...
%!              ["variable a equal 1\nvariable b equal 1\n", ...
%!               "variable e equal 0\nvariable own equal 3\n"]);
%! old(1) = newJobs (Case, [1, 2], [], 1, 'plan')(1);
%! Case.effects = resolveEffects (struct ('name', 'x', 'variables', ...
%!                                {{'own'}}, 'neutral', 3, 'limits', [3; 5]));
%! Case.effectVars = {'own'};
%! new = newJobs (Case, [1, 2], 3, 1, 'plan');
%! assert ({new.key}, {old.key});
%! on = newJobs (Case, [1, 2], 4, 1, 'plan');
%! assert (~any (strcmp ({on.key}, {old.key})));
