% WRITTENOUTSIDE  Places outside the run folder that a script writes to.
%
% CALL: PLACES = writtenOutside (TEXT, SCRIPT, ISSHELL, FOLDER, PLACE)
%
%   TEXT    of the script, its variables filled in (scriptWords);  SCRIPT  its path;
%           ISSHELL  logical: it is one of the shell
%   FOLDER  model folder, PLACE  run folder, see namedFiles (texts)
%   PLACES  1 x n cell of paths, as full ones: what redirections, tee, mkdir, touch,
%           the last word of cp, mv, ln and rsync, files that Python or Octave opens
%           for writing, and dumps, logs and restarts of an input script name
%
% All runs share such a place, those that run at the same time, too. A name with a
% variable that is not known ($$, $(mktemp), the number of a job) may be one of
% each run, so it is none; of $SCRATCH and its like everybody knows.

function places = writtenOutside (text, script, isShell, folder, place)
  text = regexprep (text, ['\$\{?(TMPDIR|TMP|TEMP|SCRATCH|SCRATCHDIR|WORKDIR|WORK)' ...
                           '(?!\w)\}?'], '/$1');
  words = opened (text);
  if isInput (script)
    words = [words, ofInput(text)];
  elseif isShell
    words = [words, ofShell(text)];
  end
  words = regexprep (words, {'^["'']|["'']$', '^~(?=/)'}, {'', getenv('HOME')});
  isKnown = cellfun (@(w) ~isempty (w) && ~any (ismember ('$`(&', w)), words);
  words = unique (words(isKnown));
  bases = [{place}, besideScript(script, folder, place), foldersOf(text, place)];
  places = cell (1, 0);
  for word = words(:)'
    at = cellfun (@(base) seenFrom (word{1}, base), bases, 'UniformOutput', false);
    isInside = cellfun (@(p) isBelow (p, place) || isBelow (p, folder) || ...
                        isDevice (p), at);
    places = [places, at(1)(~any (isInside))];
  end
  places = unique (regexprep (places, '(?<=.)/$', ''))(:)';
end

% LIGGGHTS may be started where a script of a subfolder lies.
function base = besideScript (script, folder, place)
  base = cell (1, 0);
  if isBelow (script, folder)
    base = {[place, fileparts(script)(numel (folder) + 1:end)]};
  end
end

function yes = isInput (script)
  [~, base, ending] = fileparts (script);
  yes = strncmp ([base, ending], 'in.', 3);
end

function words = opened (text)
  words = regexp (text, ['open\s*\(\s*["'']([^"'']+)["'']\s*,\s*(?:mode\s*=\s*)?' ...
                         '["''][wa]'], 'tokens');
  words = [cell(1, 0), words{:}];
end

function words = ofShell (text)
  words = regexp (text, '(?<![0-9<=>-])[012]?>{1,2}[ \t]*("[^"\n]+"|''[^''\n]+''|[^\s;&|)>}]+)', ...
                  'tokens');
  words = [cell(1, 0), words{:}];
  for part = regexp (text, '[^;&|()`{}\n]+', 'match')
    list = regexp (regexprep (part{1}, '\d?>.*$', ''), '[^\s"'']+', 'match');
    list(ismember (list, {'then', 'do', 'else', 'if', '!'})) = [];
    if isempty (list)
      continue
    end
    rest = list(2:end);
    rest = rest(~strncmp (rest, '-', 1));
    switch list{1}
      case {'mkdir', 'touch', 'tee'}
        words = [words, rest];
      case {'cp', 'mv', 'ln', 'rsync'}
        words = [words, rest(2:end)(max(end, 1):end)];
    end
  end
end

function words = ofInput (text)
  lines = regexp (text, ['^[ \t]*(?:dump|restart|write_restart|write_data|write_dump|' ...
                         'log|print|fix[ \t]+\S+[ \t]+\S+[ \t]+(?:print|ave/\w+))' ...
                         '[ \t]([^\n]*)'], 'tokens', 'lineanchors');
  lines = [cell(1, 0), lines{:}];
  words = regexp (strjoin (lines, ' '), '(?<=[\s"'']|^)(?:\.\./|/\w)[^\s"'']*', 'match');
end

function folders = foldersOf (text, place)
  moves = regexp (text, '(?:^|[;&|(]|then|do)\s*(?:cd|pushd)\s+["'']?([^\s"'';&|)]+)', ...
                  'tokens', 'lineanchors');
  folders = cellfun (@(to) seenFrom (to, place), [cell(1, 0), moves{:}], ...
                     'UniformOutput', false);
end

function path = seenFrom (word, base)
  if word(1) ~= '/'
    word = [base, '/', word];
  end
  path = plainPath (word);
end

function yes = isBelow (path, folder)
  yes = strncmp ([path, '/'], [folder, '/'], numel (folder) + 1);
end

function yes = isDevice (path)
  yes = ~isempty (regexp (path, '^/(dev/(null|std|tty|fd|zero)|proc/)', 'once'));
end

%!function places = of (text, script)
%!  isShell = nargin < 2;
%!  if isShell
%!    script = '/c/DEMmodels/M/runscript';
%!  end
%!  places = writtenOutside (text, script, isShell, '/c/DEMmodels/M', ...
%!                           '/c/optim/M/0001');
%!endfunction
%!test
%! assert (of ("awk 1 data.head > /tmp/w/out.txt; cp /tmp/w/out.txt .\n"), ...
%!         {'/tmp/w/out.txt'});
%! for text = {"mkdir -p /tmp/w", "x=1; if mkdir /tmp/w; then", "echo 2>>'/tmp/w'", ...
%!             "a | tee -a /tmp/w", "cp -r post \"/tmp/w\"", "mv a b /tmp/w/ && b", ...
%!             "cd sub\ntouch ../../../../../tmp/w", ...
%!             "python3 -c \"f = open('/tmp/w', 'w')\"", "awk '{print > \"/tmp/w\"}' a"}
%!   assert (isequal (of (text{1}), {'/tmp/w'}), text{1});
%! end
%! assert (of ("echo 1 > $SCRATCH/out"), {'/SCRATCH/out'});
%! assert (of ("echo 1 > ../last.txt"), {'/c/optim/M/last.txt'});
%!test
%! % of its own, of nobody, and of each run one
%! for text = {"a > log 2>&1", "a > /dev/null 2> /dev/stderr", "cp /data/x .", ...
%!             "awk '$1 > 3' /tmp/x", "a > /tmp/$$.txt", "cd post && a > ../out", ...
%!             "d=$(mktemp -d); a > $d/x", "a > /tmp/$SLURM_JOB_ID/x", "cp /a/x", ...
%!             "a > /c/optim/M/0001/x", "open ('/tmp/x', 'r')", "a -> /tmp/b"}
%!   assert (isempty (of (text{1})), text{1});
%! end
%!test
%! text = ["dump d all custom 1 /tmp/d*.txt id\nlog \"/tmp/l\"\nprint \"1 > 2\" file ../p\n", ...
%!         "fix m all mesh file /data/a.stl\nfix p all print 10 \"${a}\" file /tmp/p\n", ...
%!         "write_restart end.restart\n"];
%! assert (of (text, '/c/DEMmodels/M/in.M'), {'/c/optim/M/p', '/tmp/d*.txt', '/tmp/l', '/tmp/p'});
