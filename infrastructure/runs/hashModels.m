% HASHMODELS  Hashes of what decides a run besides its variables.
%
% CALL: H = hashModels (CASE)
%
%   CASE  see newCase
%   H     1 x M struct array: input (files of the model that the simulation
%         reads, number of CPUs, LIGGGHTS build where the model calls it), older
%         (the same with the build where it does not call it, as versions until
%         0.9.0 had it; else ''), funs (files of OctaveFuns, which only
%         evaluate), defaults (values declared in data.head; of effect variables
%         that it does not declare the neutral ones)
%
% A model calls LIGGGHTS where its runscript, a file that the runscript names or
% one that this names holds the word, in capitals or not.
%
% A change in OctaveFuns asks for a new evaluation of finished runs, not for
% new simulations. README, sample and pictures decide nothing.

function h = hashModels (Case)
  aside = {'OctaveFuns', 'sample', 'README.md', 'README', 'picture.png', ...
           'picture.svg', 'photo.jpg', 'log.liggghts', '.git'};
  build = hashBuild ();
  neutral = neutralEffects (Case);
  h = struct ('input', cell (1, numel (Case.models)), 'older', '', ...
              'funs', '', 'defaults', []);
  for k = 1:numel (Case.models)
    folder = Case.models(k).folder;
    text = sprintf ('%s|%d|', hashFolder (folder, aside), Case.models(k).cpu);
    h(k).input = hash ('sha256', [text, build]);
    if ~isempty (build) && ~callsLiggghts (folder)
      h(k).older = h(k).input;
      h(k).input = hash ('sha256', text);
    end
    h(k).funs = hashEvaluation (Case.models(k));
    h(k).defaults = headDefaults (fullfile (folder, 'data.head'));
    % a model without the effect has it off: its runs stay the same ones
    for v = find (~isfield (h(k).defaults, Case.effectVars))
      h(k).defaults.(Case.effectVars{v}) = neutral(v);
    end
  end
end

function yes = callsLiggghts (folder)
  names = {'runscript'};
  yes = false;
  k = 0;
  while k < numel (names) && ~yes
    k = k + 1;
    file = names{k};
    if file(1) ~= '/'
      file = fullfile (folder, file);
    end
    text = checkReadText (file);
    if numel (text) > 1e5 || any (text == 0)     % a mesh, a program: no script
      continue
    end
    yes = ~isempty (regexpi (text, 'liggghts', 'once'));
    words = regexp (text, '[\w./+-]+', 'match');
    words = unique ([words, regexprep(words, '^.*/', '')]);   % $PWD/sub.sh
    isThere = cellfun (@(w) isfile (w) && w(1) == '/' || ...
                       isfile (fullfile (folder, w)), words);
    names = [names, setdiff(words(isThere), names)];
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
%! % the build counts where the model calls LIGGGHTS, also by way of a file; a
%! % key of before is still known
%! Case = newCase (standInCase (tempname ()));
%! bin = tempname ();
%! mkdir (bin);
%! before = getenv ('PATH');
%! setenv ('PATH', [bin, ':', before]);
%! restore = onCleanup (@() setenv ('PATH', before));
%! put = @(text) writeAtomic (fullfile (bin, 'liggghts'), text);
%! put ('one');
%! system (['chmod +x ', fullfile(bin, 'liggghts')]);
%! model = @(f) fullfile (Case.models(2).folder, f);
%! put2 = @(f, text) writeAtomic (model (f), text);
%! script = fileread (model ('runscript'));
%! forms = {{'runscript', script}, {'runscript', [script, "$LIGGGHTS\n"]}, ...
%!          {'runscript', [script, ". ./go.sh\n"], ...
%!           'go.sh', "bash $PWD/sub.sh\n", 'sub.sh', "exec liggghts\n"}};
%! counts = false (1, 3);
%! for k = 1:3
%!   for i = 1:2:numel (forms{k})
%!     put2 (forms{k}{i:i + 1});
%!   end
%!   h = hashModels (Case);
%!   assert (isempty (h(2).older), k > 1);
%!   put (sprintf ('build %d', k));
%!   system (['chmod +x ', fullfile(bin, 'liggghts')]);
%!   g = hashModels (Case);
%!   counts(k) = ~strcmp (g(2).input, h(2).input);
%! end
%! assert (counts, [false, true, true]);
%! confirm_recursive_rmdir (false, 'local');
%! rmdir (bin, 's');
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
