% HASHMODELS  Hashes of what decides a run besides its variables.
%
% CALL: H = hashModels (CASE)
%
%   CASE  see newCase; whoever needs the hashes several times hands them on in
%         its field hashes
%   H     1 x M struct array: input (files of the model that the simulation
%         reads, number of CPUs, LIGGGHTS build where the model calls it, files
%         outside it that its scripts name, the same of the models that it starts
%         from), files (as input, without the build), build ('' where it is not called,
%         or not there), funs (files of OctaveFuns, which only evaluate; with
%         measured.csv also which results it reads, and where on a curve), count
%         (how many results are asked for), defaults (values declared in
%         data.head; of effect variables that it does not declare the neutral
%         ones), named (struct files, open, written: see namedFiles)
%
% A model calls LIGGGHTS where its runscript, a file that the runscript names or
% one that this names holds the word, in capitals or not.
%
% A change in OctaveFuns asks for a new evaluation of finished runs, not for
% new simulations. README, sample, pictures, settings.csv (readSettings) and
% scatter.csv, form.csv decide nothing.
%
% Errors: DEcalioc:hashFolder:missingFile

function h = hashModels (Case)
  if isfield (Case, 'hashes')
    h = Case.hashes;
    return
  end
  aside = {'OctaveFuns', 'sample', 'README.md', 'README', 'picture.png', ...
           'picture.svg', 'photo.jpg', 'log.liggghts', '.git', ...
           'settings.csv', 'scatter.csv', 'form.csv'};
  build = liggghtsBuild ();
  neutral = neutralEffects (Case);
  h = struct ('input', cell (1, numel (Case.models)), ...
              'funs', '', 'files', '', 'build', '', ...
              'count', {Case.models.nTargets}, 'defaults', [], 'named', []);
  for k = 1:numel (Case.models)
    folder = Case.models(k).folder;
    text = sprintf ('%s|%d|', hashFolder (folder, aside), Case.models(k).cpu);
    h(k).named = namedBy (Case, k);
    outside = [hashOutside(h(k).named.files), hashStages(Case, k)];
    h(k).files = hash ('sha256', [text, outside]);
    h(k).build = repmat (build, 1, callsLiggghts (folder));
    h(k).input = hash ('sha256', [text, h(k).build, outside]);
    h(k).funs = 'stage';               % asked for its state alone
    if Case.models(k).nTargets > 0
      h(k).funs = hashEvaluation (Case.models(k));
    end
    h(k).defaults = struct ();         % of runs of a table nothing is asked
    if ~isempty (folder) && isfile (fullfile (folder, 'data.head'))
      h(k).defaults = headDefaults (fullfile (folder, 'data.head'));
    end
    % a model without the effect has it off: its runs stay the same ones
    for v = find (~isfield (h(k).defaults, Case.effectVars))
      h(k).defaults.(Case.effectVars{v}) = neutral(v);
    end
  end
end

function named = namedBy (Case, k)
  place = runPlace (Case, Case.models(k).name, '0001');
  [files, open, written] = namedFiles (Case.models(k).folder, place);
  named = struct ('files', {files}, 'open', {open}, 'written', {written});
end

% Contents of what the scripts name outside the model, in no order, as paths
% change with the folder of a case; '' where they name nothing.
function text = hashOutside (files)
  text = '';
  if ~isempty (files)
    list = cellfun (@shellQuote, files, 'UniformOutput', false);
    [~, sums] = system (['sha256sum -- ', strjoin(list, ' '), ' 2> /dev/null']);
    sums = regexp (sums, '^\\?([0-9a-f]{64}) ', 'tokens', 'lineanchors');
    text = ['|', strjoin(sort ([sums{:}]), ' ')];
  end
end

% Of the models whose last state it starts from: a change there is one of its runs.
function text = hashStages (Case, k)
  text = '';
  [names, folders] = stagesOf (Case.models(k).folder);
  for i = 1:numel (names)
    of = [find(strcmp (names{i}, {Case.models.name}), 1), k];
    stage = Case.models(of(1));
    [stage.name, stage.folder, stage.nTargets] = deal (names{i}, folders{i}, 0);
    text = [text, '|', ...
            hashModels(setfield (Case, 'models', stage)).input];
  end
end

% Of the program that a model would call; '' where there is none. A build that
% repeats the runs of a former one to the last digit has its identity.
function build = liggghtsBuild ()
  [~, build] = system (['b=$(command -v liggghts) && b=$(realpath "$b") && ' ...
                        '{ cat "${b%/*}/../identity" 2> /dev/null || ' ...
                        'sha256sum < "$b"; }']);
  build = strtok (build);
end

function key = hashEvaluation (model)
  funs = fullfile (model.folder, 'OctaveFuns');
  key = '';                            % runs of a table alone need none
  if ~isempty (model.folder) && isfolder (funs)
    key = hashFolder (funs, {});
  end
  r = model.readings;
  if ~isempty (r)
    words = [{r.result}; {r.series}];
    key = hash ('sha256', [key, sprintf('|%s|%s', words{:}), ...
                           sprintf('|%.12g', r.at)]);
  end
end

% Of all files, names and contents, but WITHOUT (names below FOLDER); '' for no
% folder, in which the shell would take the current one.
function key = hashFolder (folder, without)
  key = '';
  if isempty (folder)
    return
  end
  skip = cellfun (@(n) [' ! -path ', shellQuote(['./', n]), ...
                        ' ! -path ', shellQuote(['./', n, '/*'])], ...
                  without, 'UniformOutput', false);
  % nor what editors and desktops leave there
  left = {'*~', '.*.sw?', '.#*', '#*#', '.DS_Store', 'Thumbs.db', 'desktop.ini', ...
          '.directory', '*.pyc'};
  skip = [skip, strcat({' ! -name '}, cellfun (@shellQuote, left, 'UniformOutput', false))];
  command = ['cd ', shellQuote(folder), ' && find -L . -type f', skip{:}, ...
             ' -print0 | LC_ALL=C sort -z | xargs -0 -r sha256sum'];
  [status, text] = system (command);
  if status ~= 0
    error ('DEcalioc:hashFolder:missingFile', ...
           'hashFolder: the files of %s must be readable, got: %s', ...
           folder, strtrim (text));
  end
  key = hash ('sha256', text);
end

function yes = callsLiggghts (folder)
  names = repmat ({'runscript'}, 1, ~isempty (folder));
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

%!test
%! % of files, names and contents; what only evaluates is another hash
%! Case = readyCase ();
%! h = hashModels (Case);
%! assert (size (h), [1, 2]);
%! assert (numel (h(1).input), 64);
%! assert (h, hashModels (Case));
%! changed = @(g) [~strcmp({g.input}, {h.input}), ~strcmp({g.funs}, {h.funs})];
%! other = Case;
%! other.models(1).cpu = 2;
%! assert (changed (hashModels (other)), [true, false, false, false]);
%! other = Case;
%! other.models(2).readings = struct ('result', 'w', 'series', 'w', ...
%!                                    'at', {1, 2});
%! g = hashModels (other);
%! assert (changed (g), [false, false, false, true]);
%! other.models(2).readings(2).at = 3;
%! assert (~strcmp (hashModels (other)(2).funs, g(2).funs));
%! for file = {'sample/x', 'OctaveFuns/x', 'x', 'x~', '.x.swp', '.DS_Store'; ...
%!             zeros(1, 0), 3, 1, zeros(1, 0), zeros(1, 0), zeros(1, 0)}
%!   place = fullfile (Case.models(1).folder, file{1});
%!   [~, ~] = mkdir (fileparts (place));
%!   writeAtomic (place, 'x');
%!   assert (find (changed (hashModels (Case))), file{2});
%!   unlink (place);
%! end
%!test
%! % runs of a table alone: nothing of the folder where Octave happens to be counts
%! Case = readyCase ();
%! Case.models(2).folder = '';
%! h = hashModels (Case)(2);
%! back = onCleanup (@() cd (pwd ()));
%! cd (Case.models(1).folder);
%! assert (hashModels (Case)(2), h);
%! assert (fieldnames (h.defaults), cell (0, 1));
%!error id=DEcalioc:hashFolder:missingFile
%! Case = readyCase ();
%! Case.models(1).folder = '/nowhere/at/all';
%! hashModels (Case);
%!test
%! % the build counts where the model calls LIGGGHTS, also by way of a file
%! Case = readyCase ();
%! put = @(f, text) writeAtomic (fullfile (Case.models(2).folder, f), text);
%! script = fileread (fullfile (Case.models(2).folder, 'runscript'));
%! forms = {{'runscript', script}, {'runscript', [script, "$LIGGGHTS\n"]}, ...
%!          {'runscript', [script, ". ./go.sh\n"], ...
%!           'go.sh', "bash $PWD/sub.sh\n", 'sub.sh', "exec liggghts\n"}};
%! for k = 1:3
%!   for i = 1:2:numel (forms{k})
%!     put (forms{k}{i:i + 1});
%!   end
%!   tidy = slurmFake ('one', '', {'liggghts', 'other'});
%!   h = hashModels (Case);
%!   clear tidy
%!   tidy = slurmFake ('two', '', {'liggghts', 'other'});
%!   assert (strcmp (hashModels (Case)(2).input, h(2).input), k == 1);
%!   clear tidy
%! end
%!test
%! % a build whose file identity says that it repeats the runs of a former one
%! Case = readyCase ();
%! script = fullfile (Case.models(1).folder, 'runscript');
%! writeAtomic (script, [fileread(script), "# liggghts\n"]);
%! tidy = slurmFake ('new', '', {'liggghts', 'other'});
%! place = strtok (getenv ('PATH'), ':');
%! mkdir (fullfile (place, 'bin'));
%! rename (fullfile (place, 'liggghts'), fullfile (place, 'bin', 'liggghts'));
%! setenv ('PATH', [place, '/bin:', getenv('PATH')]);
%! own = hashModels (Case)(1).input;
%! former = hash ('sha256', 'former');
%! writeAtomic (fullfile (place, 'identity'), [former, "\n"]);
%! h = hashModels (Case)(1).input;
%! unlink (fullfile (place, 'identity'));
%! same = hashModels (Case)(1).input;
%! clear tidy
%! assert (same, own);
%! assert (~strcmp (h, own));
%!test
%! % an effect that only one model has: runs of the other stay the same runs
%! Case = readyCase ();
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

% SPDX-License-Identifier: GPL-3.0-only
