% FILLTEMPLATE  Copies a folder of templates and fills in their words.
%
% CALL: fillTemplate (SOURCE, TARGET, WORDS)
%
%   SOURCE  folder of the templates (text)
%   TARGET  folder to be made (text); it is there whole or not at all
%   WORDS   scalar struct of texts: @NAME@ in the files becomes WORDS.NAME, and
%           so does NAME alone after a dot in the name of a file (in.MODEL)
%
% Errors: DEcalioc:fillTemplate:cannotWrite, :exists

function fillTemplate (source, target, words)
  if exist (target, 'file')
    error ('DEcalioc:fillTemplate:exists', ...
           ['fillTemplate: %s must not exist yet. Nothing is overwritten; ' ...
            'take another name.'], target);
  end
  draft = newDraft (make_absolute_filename (target));
  command = sprintf ('cp -rL %s %s 2>&1 && chmod -R u+w %s', ...
                     shellQuote (source), shellQuote (draft), ...
                     shellQuote (draft));
  [status, text] = system (command);
  if status ~= 0
    refuse (target, text);
  end
  tidy = onCleanup (@() system (['rm -rf ', shellQuote(draft)]));
  fillAll (draft, words);
  [err, text] = rename (draft, target);
  if err ~= 0
    refuse (target, text);
  end
end

% A folder beside the target, named after it, so that a call that was killed
% (nothing tidies then) leaves what the next one finds.
function draft = newDraft (target)
  [parent, name, ext] = fileparts (target);
  [~, ~] = mkdir (parent);
  start = fullfile (parent, ['.', name, ext, '.new-']);
  system (['rm -rf ', shellQuote(start), '*']);
  draft = draftName (start);
end

function refuse (target, text)
  error ('DEcalioc:fillTemplate:cannotWrite', ...
         ['fillTemplate: %s must be writable, got: %s. Choose a folder of ' ...
          'yours.'], target, strtrim (text));
end

function fillAll (folder, words)
  entries = dir (folder);
  entries = entries(~ismember ({entries.name}, {'.', '..'}));
  for k = 1:numel (entries)
    file = fullfile (folder, entries(k).name);
    if entries(k).isdir
      fillAll (file, words);
    else
      fillFile (file, words);
    end
  end
end

function fillFile (file, words)
  old = fileread (file);
  text = old;
  name = file;
  for word = fieldnames (words)'
    text = strrep (text, ['@', word{1}, '@'], words.(word{1}));
    name = regexprep (name, ['\.', word{1}, '$'], ['.', words.(word{1})]);
  end
  if ~strcmp (text, old)
    writeAtomic (file, text);
  end
  if ~strcmp (name, file)
    rename (file, name);
  end
end

%!test
%! base = tempname ();
%! mkdir (fullfile (base, 'from', 'sub'));
%! writeAtomic (fullfile (base, 'from', 'in.MODEL'), 'a @MODEL@ @X@');
%! writeAtomic (fullfile (base, 'from', 'sub', 'b'), '@MODEL@');
%! to = fullfile (base, 'a b', 'To''s');
%! fillTemplate (fullfile (base, 'from'), to, struct ('MODEL', 'Mine'));
%! assert (fileread (fullfile (to, 'in.Mine')), 'a Mine @X@');
%! assert (fileread (fullfile (to, 'sub', 'b')), 'Mine');
%! assert (numel (readdir (fullfile (base, 'a b'))), 3);
%!test
%! % what a killed call has left goes, another folder's draft stays
%! base = tempname ();
%! mkdir (fullfile (base, 'from'));
%! writeAtomic (fullfile (base, 'from', 'file'), 'text');
%! mkdir (fullfile (base, '.to.new-12'));
%! mkdir (fullfile (base, '.to2.new-1'));
%! fillTemplate (fullfile (base, 'from'), fullfile (base, 'to'), struct ());
%! assert (sort (readdir (base)'), {'.', '..', '.to2.new-1', 'from', 'to'});
%!error id=DEcalioc:fillTemplate:exists
%! fillTemplate (pwd (), pwd (), struct ());
%!error id=DEcalioc:fillTemplate:cannotWrite
%! fillTemplate ('/nowhere/at/all', tempname (), struct ());

% SPDX-License-Identifier: GPL-3.0-only
