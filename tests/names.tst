% Names that mean something to a shell, to glob or to the path of Octave.

%!function folder = hostile ()
%!  folder = fullfile (tempname (), ['$(touch $PWNED) `touch $PWNED` ', ...
%!                                   'it''s a "[1]" & b; x']);
%!  setenv ('PWNED', fullfile (fileparts (folder), 'pwned'));
%!endfunction
%!function [status, out] = decalioc (words, folder)
%!  program = fullfile (fileparts (fileparts (which ('startToolbox'))), ...
%!                      'bin', 'decalioc');
%!  [status, out] = system ([shellQuote(program), ' ', words, ' ', ...
%!                           shellQuote(folder), ' 2>&1']);
%!endfunction

%!test
%! % nothing in the name of a case or of its files is run, and the case works
%! base = hostile ();
%! for name = {'', '$(touch $PWNED)', '`touch $PWNED`', '"; touch $PWNED; "'}
%!   folder = [base, name{1}];
%!   if ~isempty (name{1})
%!     folder = fullfile (fileparts (base), name{1});
%!   end
%!   raw = standInCase (folder);
%!   writeLoadInput (folder);
%!   sample = fullfile (folder, 'DEMmodels', 'First', 'sample');
%!   mkdir (sample);
%!   writeAtomic (fullfile (sample, 'out'), "1\n2\n");
%!   [status, out] = decalioc ('check', folder);
%!   assert (status == 0, out);
%!   assert (~isfile (getenv ('PWNED')), folder);
%! end
%! folder = base;
%! raw.folder = base;
%! assert (evaluateDEM ([1, 2], newCase (raw)), [3, 2, -1], 1e-12);
%! [status, out] = decalioc ('export', folder);
%! assert (status == 0, out);
%! assert (~isfile (getenv ('PWNED')));

%!test
%! % a script of the user's, and a file that it names
%! folder = hostile ();
%! mkdir (folder);
%! evil = 'a$(touch${IFS}$PWNED)`touch${IFS}$PWNED`''[1]''.stl';
%! writeAtomic (fullfile (folder, evil), 'solid');
%! script = fullfile (folder, 'in.mine');
%! writeAtomic (script, ["variable mu index 0.3\nfix a all mesh/surface ", ...
%!                       'file ', evil, "\nprint \"${mu}\" file out\n"]);
%! given = struct ('model', 'Mine', 'script', script, 'output', 'out', ...
%!                 'seed', '', 'vary', {{'mu=0.2:0.8'}}, 'set', {{}}, ...
%!                 'target', {{'a=1'}});
%! root = fileparts (fileparts (which ('startToolbox')));
%! target = fullfile (folder, 'DEMmodels', 'Mine');
%! newScriptModel (root, target, given);
%! assert (isfile (fullfile (target, evil)));
%! assert (~isfile (getenv ('PWNED')));

%!test
%! % what goes into the text of a program is checked as a name
%! folder = tempname ();
%! mkdir (folder);
%! script = fullfile (folder, 'in.mine');
%! writeAtomic (script, "variable mu index 0.3\n");
%! good = struct ('model', 'Mine', 'script', script, ...
%!                'output', 'post/out.txt', 'seed', 'seed', ...
%!                'vary', {{'mu=0.2:0.8'}}, ...
%!                'set', {{'depth=0.1'}}, 'target', {{'a (m)=1'}});
%! root = fileparts (fileparts (which ('startToolbox')));
%! bad = {'output', 'out'']); system (''x'; 'output', '../out'; ...
%!        'output', '/tmp/out'; 'output', "a\nb"; ...
%!        'seed', 'x" : system ("y'; 'seed', 'a b'; 'seed', '1a'; ...
%!        'vary', {'m''u=0.2:0.8'}; 'vary', {'a;b=0.2:0.8'}; ...
%!        'set', {'d$(x)=1'}; 'set', {"a\nb=1"}; 'target', {"a\nb=1"}};
%! for k = 1:rows (bad)
%!   given = good;
%!   given.(bad{k, 1}) = bad{k, 2};
%!   caught = '';
%!   try
%!     newScriptModel (root, fullfile (folder, 'M'), given);
%!   catch err
%!     caught = err.identifier;
%!   end
%!   assert (any (strcmp (regexprep (caught, '^.*:', ''), ...
%!                        {'badValue', 'unknownName'})), bad{k, 1});
%!   assert (~isfolder (fullfile (folder, 'M')));
%! end
%! copy = fullfile (folder, 'in.$(x)');
%! writeAtomic (copy, "variable mu index 0.3\n");
%! given = good;
%! given.script = copy;
%! caught = '';
%! try
%!   newScriptModel (root, fullfile (folder, 'M'), given);
%! catch err
%!   caught = err.identifier;
%! end
%! assert (caught, 'DEcalioc:newScriptModel:badValue');
%! newScriptModel (root, fullfile (folder, 'M'), good);

%!test
%! % a colon parts the folders of the path of Octave: refused before any run
%! folder = fullfile (tempname (), 'run 12:30');
%! standInCase (folder);
%! writeLoadInput (folder);
%! [status, out] = decalioc ('check', folder);
%! assert (status, 1);
%! assert (~isempty (strfind (out, 'without a colon')), out);
%! [status, out] = decalioc ('run', folder);
%! assert (status, 1);
%! assert (~isfolder (fullfile (folder, 'optim')));

%!test
%! % the toolbox in a folder with brackets, spaces and quotes works; with a
%! % colon it says so
%! root = fileparts (fileparts (which ('startToolbox')));
%! folder = tempname ();
%! raw = standInCase (folder);
%! writeLoadInput (folder);
%! parts = {'bin', 'infrastructure', 'tools', 'VERSION', 'DEcalioc.m', ...
%!          'diagnoseGap.m'};
%! for name = {'a [1] it''s *', 'a:b'}
%!   place = fullfile (folder, 'copy', name{1});
%!   mkdir (place);
%!   for part = parts
%!     system (['cp -r ', shellQuote(fullfile (root, part{1})), ' ', ...
%!              shellQuote([place, '/'])]);
%!   end
%!   lines = {[shellQuote(fullfile (place, 'bin', 'decalioc')), ' check .'], ...
%!            ['octave-cli ', shellQuote(fullfile (place, 'DEcalioc.m'))], ...
%!            ['octave-cli ', shellQuote(fullfile (place, 'diagnoseGap.m'))]};
%!   lines = lines(1:1 + 2 * any (name{1} == ':'));
%!   for line = lines
%!     [status, out] = system (['cd ', folder, ' && ', line{1}, ' 2>&1']);
%!     assert (status == any (name{1} == ':'), out);
%!     hasWord = ~isempty (strfind (out, 'without a colon'));
%!     assert (hasWord == any (name{1} == ':'), out);
%!   end
%! end

%!test
%! % without HOME, as cron starts it, the runs of the store count all the same
%! raw = standInCase (tempname ());
%! writeLoadInput (raw.folder);
%! program = shellQuote (fullfile (raw.root, 'bin', 'decalioc'));
%! [status, out] = system ([program, ' check --try ', raw.folder, ' 2>&1']);
%! assert (status == 0, out);
%! [status, out] = system (['env -i PATH="$PATH" ', program, ' check ', ...
%!                          raw.folder, ' 2>&1']);
%! assert (status == 0, out);
%! assert (~isempty (strfind (out, '14 new, 2 taken from the store')), out);
%! assert (isempty (strfind (out, 'old runs')), out);

%!test
%! % a TMPDIR that is not there, a German locale where the machine has one: the
%! % same words and runs
%! raw = standInCase (tempname ());
%! writeLoadInput (raw.folder);
%! words = [shellQuote(fullfile (raw.root, 'bin', 'decalioc')), ...
%!          ' check --try ', raw.folder];
%! [status, out] = system (['TMPDIR=/proc/nowhere ', words, ' 2>&1']);
%! assert (status == 0, out);
%! assert (~isempty (strfind (out, '/tmp is taken')), out);
%! [status, out] = system (['LC_ALL=de_DE.UTF-8 ', words, ' 2>&1']);
%! assert (status == 0, out);
%! assert (~isempty (strfind (out, '2 taken from the store')), out);

%!test
%! % whoever starts a run, its numbers have a point, and all else is as there
%! folder = tempname ();
%! mkdir (folder);
%! writeAtomic (fullfile (folder, 'runscript'), ...
%!   "awk 'BEGIN { print 1.5 }'\nprintf '%.2f\\n' 2.5\nlocale\n");
%! guard = shellQuote (fullfile (fileparts (which ('startRun')), 'guard.sh'));
%! for words = {'LC_ALL=de_DE.UTF-8', 'LC_ALL= LC_NUMERIC=de_DE.UTF-8', ...
%!              'LC_CTYPE=C LANG=C LC_ALL=de_DE.UTF-8'}
%!   [status, out] = system ([words{1}, ' bash ', guard, ' ', folder, ' 2>&1']);
%!   assert (status == 0, out);
%!   out = fileread (fullfile (folder, 'stdout.txt'));
%!   assert (strncmp (out, "1.5\n2.50\n", 9), out);
%!   assert (isempty (regexp (words{1}, 'LC_ALL=d')) || ...
%!           ~isempty (regexp (out, 'LC_CTYPE="?de_DE')), out);
%! end
%! confirm_recursive_rmdir (false, 'local');
%! rmdir (folder, 's');

% SPDX-License-Identifier: GPL-3.0-only
