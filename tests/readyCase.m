% READYCASE  The case of standInCase in a new folder, as newCase makes it.
%
% CALL: CASE = readyCase ()
%
% newCase starts an Octave that looks at the models, for a second of processor: here it
% does so once for all tests of this Octave, which get copies.
%
% See also: standInCase, newCase

function Case = readyCase ()
  kept = fullfile (getenv ('TMPDIR'), sprintf ('readyCase-%d.mat', getpid ()));
  if isempty (getenv ('TMPDIR')) || ~isfile (kept)
    Case = newCase (standInCase (tempname ()));
    if isempty (getenv ('TMPDIR'))
      return
    end
    save ('-binary', kept, 'Case');
  end
  Case = load (kept).Case;
  [first, Case.folder] = deal (Case.folder, tempname ());
  system (sprintf ('cp -r %s %s', first, Case.folder));
  Case.store = strrep (Case.store, first, Case.folder);
  for k = 1:numel (Case.models)
    Case.models(k).folder = strrep (Case.models(k).folder, first, Case.folder);
  end
end

%!test
%! % the same case, but for its folder
%! Case = readyCase ();
%! raw = standInCase ([Case.folder, '-2']);
%! own = newCase (raw);
%! own.folder = strrep (own.folder, raw.folder, Case.folder);
%! own.store = strrep (own.store, raw.folder, Case.folder);
%! for k = 1:2
%!   own.models(k).folder = strrep (own.models(k).folder, raw.folder, Case.folder);
%! end
%! assert (isequaln (Case, own));
%! other = readyCase ();
%! assert (~strcmp (other.folder, Case.folder));
%! assert (hashModels (other), hashModels (Case));

% SPDX-License-Identifier: GPL-3.0-only
